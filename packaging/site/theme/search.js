// Finds sections that have all words of a query. The index is a script, so that this works from disk, too.
(() => {
  'use strict';
  const kShown = 20;
  const kAround = 70;
  const query = document.getElementById('query');
  const results = document.getElementById('results');
  const article = document.querySelector('article');

  /** Words in the title count most, then how often the words are in the text. */
  function scoreOf(section, words) {
    const title = section.title.toLowerCase();
    let score = 0;
    for (const word of words) {
      const inText = section.lower.split(word).length - 1;
      if (!title.includes(word) && inText === 0) return 0;
      score += (title.includes(word) ? 20 : 0) + Math.min(inText, 5);
    }
    return score;
  }

  function excerpt(section, word) {
    const at = Math.max(0, section.lower.indexOf(word));
    const from = Math.max(0, at - kAround);
    const text = section.text.slice(from, at + word.length + kAround);
    return `${from > 0 ? '… ' : ''}${text} …`;
  }

  function resultOf(section, words) {
    const link = document.createElement('a');
    link.href = `${siteRoot}/${section.url}`;
    link.textContent = section.title;
    const text = document.createElement('p');
    text.textContent = excerpt(section, words[0]);
    const item = document.createElement('li');
    item.append(link, text);
    return item;
  }

  function search() {
    const words = query.value.toLowerCase().split(/\s+/).filter((word) => word.length > 1);
    results.hidden = words.length === 0;
    article.hidden = words.length > 0;
    if (words.length === 0) return;
    const found = siteSections.map((section) => ({section, score: scoreOf(section, words)})).filter(({score}) => score > 0);
    found.sort((a, b) => b.score - a.score);
    const count = document.createElement('h1');
    count.textContent = found.length === 0 ? 'No section has these words.' : `${found.length} sections`;
    const list = document.createElement('ol');
    list.append(...found.slice(0, kShown).map(({section}) => resultOf(section, words)));
    results.replaceChildren(count, list);
  }

  for (const section of siteSections) section.lower = section.text.toLowerCase();
  query.addEventListener('input', search);
  results.addEventListener('click', (event) => {
    if (event.target instanceof HTMLAnchorElement) query.value = '';
    setTimeout(search);
  });
})();
