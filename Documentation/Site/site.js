// The menu is open where there is room for it; the search looks through the pages that pages.js holds.
const menu = document.querySelector('.menu');
const room = matchMedia('(min-width: 60rem)');
const fold = () => { menu.open = room.matches; };
room.addEventListener('change', fold);
fold();

const here = location.pathname.split('/').pop() || 'index.html';
for (const link of menu.querySelectorAll('a')) {
  if (link.getAttribute('href') === here) link.setAttribute('aria-current', 'page');
}

const field = document.getElementById('search');
const list = document.getElementById('found');

// A word counts most in the title, then in the words that users would call a filter.
function score(page, words) {
  const [title, other, text] = [page.title, page.words, page.text].map((part) => part.toLowerCase());
  let sum = 0;
  for (const word of words) {
    const value = (title.includes(word) ? 30 : 0) + (other.includes(word) ? 12 : 0) +
      Math.min(5, text.split(word).length - 1);
    if (value === 0) return 0;
    sum += value;
  }
  return sum;
}

function excerpt(page, word) {
  const at = Math.max(0, page.text.toLowerCase().indexOf(word) - 50);
  return (at > 0 ? '\u2026' : '') + page.text.slice(at, at + 150) + '\u2026';
}

field.addEventListener('input', () => {
  const words = field.value.toLowerCase().split(/\s+/).filter(Boolean);
  const hits = words.length === 0 ? [] : pages.map((page) => ({ page, value: score(page, words) }))
    .filter((hit) => hit.value > 0).sort((one, two) => two.value - one.value).slice(0, 12);
  list.replaceChildren(...hits.map(({ page }) => {
    const link = document.createElement('a');
    link.href = page.page;
    link.textContent = page.title;
    const small = document.createElement('small');
    small.textContent = excerpt(page, words[0]);
    link.append(small);
    const item = document.createElement('li');
    item.append(link);
    return item;
  }));
  if (words.length > 0 && hits.length === 0) list.textContent = 'Nothing found.';
  list.hidden = words.length === 0;
});
field.addEventListener('keydown', (event) => {
  if (event.key === 'Enter') list.querySelector('a')?.click();
  if (event.key === 'Escape') { field.value = ''; list.hidden = true; }
});
