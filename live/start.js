// A page of its own for live figures: the address of one that is alone says what was moved.

const figures = [...document.querySelectorAll(".tracefig-live")];
for (const root of figures) {
    enliven(root, figures.length === 1);
}
