//! Variants of an exercise by number: other bodies, the same question, and an answer of three digits at most.
//!
//! Hardly any answer to random numbers is short: distances are roots. So numbers are drawn near the scene's
//! own, in its own steps, with Pythagorean directions (3, 4, 5), (7, 24, 25), whose sines are short; each is
//! answered, and kept where the proved bounds hold a number of three digits, and no other one. The draws are
//! one sequence, so that a number stands for one variant for ever.

use oorandom::Rand64;

use crate::collision::{Answer, Outcome};
use crate::figure::called::Called;
use crate::figure::describe::closing;
use crate::figure::runs::Runs;
use crate::figure::standing::standing;
use crate::scene::{Numbers, Scene, SceneFile, Template};

use super::answers::{Asked, answers};

/// The seed of the one sequence.
const SEQUENCE: u128 = 19;
/// Draws in a row of which none is kept, after which there are no more variants: of circles, whose centres
/// must lie at a whole distance, one in some fifty is kept.
const DRAWS: usize = 2_000;
/// Steps in units, the largest first: the first that the scene's own numbers are whole multiples of is taken.
/// Each is one by this.
const PARTS: [f64; 5] = [2.0, 4.0, 5.0, 10.0, 20.0];
/// How far a number in parts may be from a whole one: some roundings.
const WHOLE: f64 = 1e-9;
/// Steps that a place or a velocity moves by at most.
const FAR: u64 = 6;
/// Steps that a size changes by at most.
const NEAR: u64 = 5;
/// Steps of angles and of spins, degrees, the largest first: the first that the scene's own number is a whole
/// multiple of is taken, and of none stays. A quarter turn leaves every coordinate short, the others some.
const TURNS: [f64; 6] = [90.0, 45.0, 30.0, 15.0, 10.0, 5.0];
/// Steps that an angle or a spin changes by at most: with quarter turns, to every one of them.
const TURNED: u64 = 2;
/// Cosines and sines of directions that are short, in the first quadrant.
const DIRECTIONS: [[f64; 2]; 4] = [[0.6, 0.8], [0.8, 0.6], [0.28, 0.96], [0.96, 0.28]];
/// Why there are not as many variants as were asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooFew {
    /// How many there are.
    pub found: usize,
}

/// A variant, and the numbers that it has in the place of the scene's own.
#[derive(Clone, Debug)]
pub struct Found {
    /// The scene.
    pub file: SceneFile,
    /// The numbers, as [`Template::with`] takes them.
    pub numbers: Vec<Vec<f64>>,
}

/// The first `count` variants of an exercise: the same for every run and machine.
///
/// # Errors
/// Where there are fewer; none where the scene is no exercise.
///
/// ```
/// use tracefig::{figure::exercise::search, scene::open_text};
/// let text = "exercise.ask = 'd'\nshapes.A = { kind = 'circle', radius = 1 }\n\
///     shapes.B = { kind = 'circle', radius = 1, position = [3, 4] }\n\
///     query = { kind = 'separation', of = ['A', 'B'] }";
/// let found = search(&open_text("s.toml", text)?.template(), 3).unwrap();
/// assert!(found[0].numbers != found[1].numbers && found.len() == 3);
/// # Ok::<(), Box<tracefig::Refused>>(())
/// ```
pub fn search(template: &Template, count: usize) -> Result<Vec<Found>, TooFew> {
    let mut found: Vec<Found> = Vec::new();
    let own: Vec<Vec<f64>> = template.numbers().iter().map(|field| field.values.clone()).collect();
    let Some(kind) = template.with(&own).ok().and_then(|file| Kind::of(&file.scene)) else {
        return Err(TooFew { found: 0 });
    };
    let mut random = Rand64::new(SEQUENCE);
    let mut in_vain = 0;
    while found.len() < count && in_vain < DRAWS {
        in_vain += 1;
        let numbers: Vec<_> = template.numbers().iter().map(|field| drawn(field, &mut random)).collect();
        if numbers == own || found.iter().any(|known| known.numbers == numbers) {
            continue;
        }
        let Ok(file) = template.with(&numbers) else { continue };
        if Kind::of(&file.scene).is_some_and(|other| other.is_short && other.is_like(&kind)) {
            found.push(Found { file, numbers });
            in_vain = 0;
        }
    }
    if found.len() == count { Ok(found) } else { Err(TooFew { found: found.len() }) }
}

/// What variants of an exercise have in common.
struct Kind {
    /// How the answer turned out, in a clause.
    standing: &'static str,
    /// How many directions tie.
    ties: u32,
    /// Whether every number that is asked for has three digits at most.
    is_short: bool,
    /// Whether bodies that hit do so within the motion, and go into each other: a graze, or a hit at the very
    /// end, may be missed by who computes it in other roundings.
    is_clear: bool,
}

impl Kind {
    /// What a scene is like; `None` where it is no exercise, or lacks what it asks for.
    fn of(scene: &Scene) -> Option<Self> {
        let exercise = scene.exercise.as_ref()?;
        let runs = Runs::of(scene, Called::default());
        let run = runs.own(scene, scene.query.time);
        let all = answers(scene, &runs, exercise);
        let ties = match &run.answer {
            Answer::Separation(found) => found.ties,
            _ => 1,
        };
        let is_short = all.iter().all(is_short);
        let kind =
            Self { standing: standing(&run.answer), ties, is_short, is_clear: is_clear(scene, &run.answer) };
        (all.len() == exercise.ask.len()).then_some(kind)
    }

    /// Whether an answer turned out as another one, with one way out and as clear where that one is.
    fn is_like(&self, other: &Self) -> bool {
        self.standing == other.standing && self.ties == other.ties && (self.is_clear || !other.is_clear)
    }
}

/// Whether a hit is within the motion and no graze; so is any other answer.
fn is_clear(scene: &Scene, answer: &Answer) -> bool {
    let Answer::Impact(impact) = answer else { return true };
    let Outcome::Hit { time, contact } = &impact.outcome else { return true };
    time.hi < 1.0 && closing(scene, time.lo, *contact.normal, contact.points) > 0.0
}

/// Whether an answer is a number of three digits at most, and no other number; 0 is no answer to a length or
/// a time.
fn is_short(asked: &Asked) -> bool {
    asked.short() == Some(asked.value()) && (asked.value() != 0.0 || !asked.is_proved)
}

/// Numbers near those of a field.
fn drawn(field: &Numbers, random: &mut Rand64) -> Vec<f64> {
    let parts = parts(&field.values);
    let mut step = |most: u64| {
        let drawn = u32::try_from(random.rand_range(0..2 * most + 1)).unwrap_or(0);
        f64::from(drawn) - f64::from(u32::try_from(most).unwrap_or(0))
    };
    match field.key {
        "rotation" => {
            // Two draws choose one of four, and two the quadrant.
            let [one, two, left, down] = [(); 4].map(|()| random.rand_range(0..2) == 1);
            let [cos, sin] = DIRECTIONS[2 * usize::from(one) + usize::from(two)];
            vec![if left { -cos } else { cos }, if down { -sin } else { sin }]
        }
        "position" => field.values.iter().map(|x| ((x * parts).round() + step(FAR)) / parts).collect(),
        // What rests or moves along an axis still does.
        "velocity" => {
            let moved = |&x: &f64| if x == 0.0 { x } else { ((x * parts).round() + step(FAR)) / parts };
            field.values.iter().map(moved).collect()
        }
        "angle_deg" => field.values.iter().map(|x| x + turn(*x) * step(TURNED)).collect(),
        // What turns still does.
        "angular_velocity_deg" => {
            let spun =
                |&x: &f64| Some(x + turn(x) * step(TURNED)).filter(|y| x != 0.0 && *y != 0.0).unwrap_or(x);
            field.values.iter().map(spun).collect()
        }
        _ => field.values.iter().map(|x| ((x * parts).round() + step(NEAR)).max(1.0) / parts).collect(),
    }
}

/// By how much an angle or a spin changes in a step, degrees; 0 where it is no round one.
fn turn(degrees: f64) -> f64 {
    TURNS.into_iter().find(|step| degrees % step == 0.0).unwrap_or(0.0)
}

/// How many parts of a unit the steps of these numbers are.
fn parts(values: &[f64]) -> f64 {
    let is_whole = |parts: &f64| values.iter().all(|x| (x * parts - (x * parts).round()).abs() < WHOLE);
    PARTS.into_iter().find(|parts| is_whole(parts)).unwrap_or(PARTS[3])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::open_text;

    fn template(text: &str) -> Template {
        let scene = format!("{text}\nshapes.A = {{ kind = 'circle', radius = 1 }}");
        open_text("s.toml", &scene).unwrap().template()
    }

    const PAIR: &str = "exercise.ask = 'd'
        shapes.B = { kind = 'box', half_extents = [1, 0.5], position = [3, 0.5], rotation = [0.6, 0.8] }
        query = { kind = 'separation', of = ['A', 'B'] }";

    #[test]
    fn a_number_stands_for_one_variant_for_ever() {
        let found = search(&template(PAIR), 12).unwrap();
        let first = [vec![0.5], vec![4.0, -0.5], vec![3.0, 2.0], vec![0.96, 0.28]];
        assert_eq!(found[0].numbers, first, "another sequence makes every sheet that was handed out wrong");
        // How many are asked for does not change them.
        let fewer = search(&template(PAIR), 3).unwrap();
        assert!(fewer.iter().zip(&found).all(|(a, b)| a.numbers == b.numbers));
        for (i, one) in found.iter().enumerate() {
            assert!(found[..i].iter().all(|other| other.numbers != one.numbers), "{i} stands twice");
            let kind = Kind::of(&one.file.scene).unwrap();
            assert!(kind.is_short && kind.standing == "the bodies are apart" && kind.ties == 1);
        }
    }

    #[test]
    fn numbers_stay_in_the_steps_of_the_scene() {
        for found in search(&template(PAIR), 12).unwrap() {
            let [radius, position, half, rotation] = &found.numbers[..] else { panic!() };
            let is_in_halves = |x: &f64| (2.0 * x).fract() == 0.0;
            assert!(radius.iter().chain(position).chain(half).all(is_in_halves), "{:?}", found.numbers);
            assert!(half.iter().chain(radius).all(|&x| x > 0.0));
            assert!((rotation[0] * rotation[0] + rotation[1] * rotation[1] - 1.0).abs() < 1e-15);
        }
        assert_eq!(
            [parts(&[1.2, 0.9]), parts(&[1.25]), parts(&[3.0, 0.5]), parts(&[0.3333])],
            [10.0, 4.0, 2.0, 10.0]
        );
    }

    #[test]
    fn angles_and_spins_vary_in_round_steps_and_what_rests_stays() {
        let text = |angle: &str| {
            format!(
                "exercise.ask = ['h.x', 'h.y']
                shapes.B = {{ kind = 'box', half_extents = [2, 1], {angle} }}
                query = {{ kind = 'bounds', of = ['B'], time = 1 }}"
            )
        };
        let varied = |angle: &str| -> Vec<Vec<f64>> {
            let found = search(&template(&text(angle)), 12).unwrap();
            let turned = |one: Found| one.numbers[1..].iter().flatten().copied().collect();
            found.into_iter().map(turned).collect()
        };
        let turns = varied("angle_deg = 90, angular_velocity_deg = 90");
        for i in [0, 1] {
            let values: std::collections::BTreeSet<_> = turns.iter().map(|one| one[i].to_bits()).collect();
            assert!(values.len() > 2 && turns.iter().all(|one| one[i] % 90.0 == 0.0), "{turns:?}");
        }
        assert!(turns.iter().all(|one| one[1] != 0.0), "what turns still does: {turns:?}");
        assert!(varied("angle_deg = 90, angular_velocity_deg = 0").iter().all(|one| one[1] == 0.0));
        assert_eq!([turn(30.0), turn(-135.0), turn(17.0), turn(0.0)], [30.0, 45.0, 0.0, 90.0]);
    }

    #[test]
    fn of_hits_only_those_vary_that_are_no_graze_and_not_at_the_end() {
        let text = "exercise.ask = 'time'
            shapes.B = { kind = 'box', half_extents = [1, 0.5], position = [4, 0.5], velocity = [-4, 0] }
            query = { kind = 'linear-sweep', of = ['A', 'B'] }";
        for one in search(&template(text), 40).unwrap() {
            let scene = &one.file.scene;
            assert!(is_clear(scene, &crate::scene::solve(scene)), "{:?}", one.numbers);
        }
    }

    #[test]
    fn where_no_answer_is_short_that_is_said() {
        let turned = PAIR.replace("rotation = [0.6, 0.8]", "angle_deg = 17");
        // Its vertices alone can be at a short distance.
        let few =
            search(&template(&turned.replace("radius = 1", "radius = 1.0001")), 40).map(|all| all.len());
        assert!(few.is_err(), "{few:?}");
        let plain = search(&template(&PAIR.replace("exercise.ask = 'd'", "")), 1);
        assert_eq!(plain.map(|all| all.len()), Err(TooFew { found: 0 }));
    }
}
