// The eyes of check_site.sh: opens each page in a frame as wide as a phone, then as wide as a desk's window, and writes
// what a reader cannot see there, and the document as it stands after every script has run.
'use strict';
const widths = [420, 1280];
const smallest_letters = 9;  // px, in a figure

const short = text => text.trim().replace(/\s+/g, ' ').slice(0, 60);
const named = e => `${e.tagName.toLowerCase()}${e.id ? '#' + e.id : ''} '${short(e.textContent)}'`;
const scrolls = e => /auto|scroll/.test(getComputedStyle(e).overflowX);
const is_shown = e => e.checkVisibility({ visibilityProperty: true, contentVisibilityAuto: true });

// Where a box's owner can be seen at all: within every box around it that cuts or scrolls.
function window_of(owner) {
  const edge = { left: 0, right: Infinity };
  for (let e = owner; e.parentElement; e = e.parentElement) {
    if (getComputedStyle(e).overflowX === 'visible') continue;
    const box = e.getBoundingClientRect();
    edge.left = Math.max(edge.left, box.left);
    edge.right = Math.min(edge.right, box.right);
  }
  return edge;
}

// What is wider than its box and cut there. On a phone tables, listings and formulas may scroll inside the page, but not
// the page itself; at a desk nothing needs to.
function cut_off(page, width) {
  const faults = [], root = page.documentElement, beyond = root.scrollWidth - root.clientWidth;
  if (beyond > 1) {
    const is_wide = e => e.getBoundingClientRect().right > root.clientWidth + 1 && is_shown(e);
    const free = [...page.body.querySelectorAll('*')].filter(
        e => is_wide(e) && window_of(e.parentElement).right === Infinity);
    faults.push(`scrolls sideways by ${beyond} px` + (free.length ? `: ${named(free[free.length - 1])}` : ''));
  }
  for (const e of page.body.querySelectorAll('*')) {
    if (e.scrollWidth <= e.clientWidth + 1 || e.clientWidth === 0 || e.closest('svg, #nav-path, .sm-dox')) continue;
    if (getComputedStyle(e).overflowX === 'visible' || !is_shown(e)) continue;
    const by_itself = scrolls(e) && !e.matches('.contents, body');
    if (width > 1000 || !by_itself) faults.push(`cut off, ${e.scrollWidth - e.clientWidth} px of ${named(e)}`);
  }
  return faults;
}

// The rectangles of a page's words and drawings. Menus that open by themselves come and go.
const unseen = 'script, style, svg, div.line, pre, #main-menu ul';
function* seen(page) {
  const walker = page.createTreeWalker(page.body, NodeFilter.SHOW_TEXT);
  const range = page.createRange();
  while (walker.nextNode()) {
    const owner = walker.currentNode.parentElement;
    if (!walker.currentNode.data.trim() || owner.closest(unseen) || !is_shown(owner)) continue;
    range.selectNodeContents(walker.currentNode);
    for (const box of range.getClientRects()) yield [owner, box];
  }
  for (const e of page.querySelectorAll('.contents svg, .contents img, .contents object')) {
    if (is_shown(e)) yield [e, e.getBoundingClientRect()];
  }
}

// Words and drawings with something else on top of their beginning, middle or end.
function covered(page) {
  const faults = new Set();
  for (const [owner, box] of seen(page)) {
    if (box.width < 3 || box.height < 3) continue;
    let edge;
    for (const x of [box.left + 1.5, (box.left + box.right) / 2, box.right - 1.5]) {
      const top = page.elementFromPoint(x, (box.top + box.bottom) / 2);
      if (!top || top.matches('area') || owner.contains(top) || top.contains(owner)) continue;
      edge = edge || window_of(owner);
      if (x > edge.left && x < edge.right) faults.add(`covered: ${named(owner)} by ${named(top)}`);
    }
  }
  return [...faults];
}

// Lists that begin again at 1 after an interruption.
function restarted(page) {
  const again = list => {
    let before = list.previousElementSibling;
    if (before && !before.matches('ol, h1, h2, h3, h4')) before = before.previousElementSibling;
    return before && before.matches('ol') && list.start === 1;
  };
  return [...page.querySelectorAll('ol')].filter(again).map(list => `a list begins again at 1: ${named(list)}`);
}

// Where the words of an element begin: the first line of its first text.
function first_words(page, element) {
  const walker = page.createTreeWalker(element, NodeFilter.SHOW_TEXT), range = page.createRange();
  while (walker.nextNode()) {
    if (!walker.currentNode.data.trim() || !is_shown(walker.currentNode.parentElement)) continue;
    range.selectNodeContents(walker.currentNode);
    return range.getClientRects()[0];
  }
}

// Cells of a row and columns of a list that do not begin on one line, and heads of a table with no gap between them.
// Cells with formulas are as high as these.
function uneven(page) {
  const faults = [];
  const apart = (what, boxes, slack) => {
    const ends = boxes.filter(box => box).map(box => (box.top + box.bottom) / 2);
    const off = Math.max(...ends) - Math.min(...ends);
    if (off > slack) faults.push(`${off.toFixed(0)} px out of line: ${named(what)}`);
  };
  for (const row of page.querySelectorAll('table tr')) {
    const cells = [...row.children].map(cell => first_words(page, cell));
    const is_text = row.matches('.markdownTable tr, .doxtable tr') && !row.querySelector('svg, img');
    if (is_text) apart(row, cells, 2);
    for (let i = 1; row.querySelector('th') && i < cells.length; ++i) {
      const runs_on = cells[i - 1] && cells[i] && cells[i].left < cells[i - 1].right + 5;
      if (runs_on) faults.push(`heads run together: ${named(row.children[i])}`);
    }
  }
  for (const list of page.querySelectorAll('div.toc > ul')) {
    const boxes = [...list.querySelectorAll('li')].map(item => first_words(page, item));
    apart(list, boxes.filter((box, i) => i === 0 || box.top < boxes[i - 1].top), 2);
  }
  return faults;
}

// Letters of figures that lie on one another, beyond the frame, or are too small to read.
function unreadable(page) {
  const faults = [];
  for (const object of page.querySelectorAll('object')) {
    const svg = object.contentDocument && object.contentDocument.documentElement;
    if (!svg || !is_shown(object)) continue;
    const name = object.getAttribute('data').replace(/.*\//, ''), frame = svg.getBoundingClientRect();
    const letters = [...svg.querySelectorAll('text')].filter(t => t.textContent.trim());
    const boxes = letters.map(t => t.getBoundingClientRect());
    const meet = (a, b) => Math.min(a.right, b.right) - Math.max(a.left, b.left) > 2 &&
                           Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 0.35 * Math.min(a.height, b.height);
    for (let i = 0; i < boxes.length; ++i) {
      const over = letters.slice(0, i).find((_, k) => meet(boxes[k], boxes[i]));
      if (over) faults.push(`${name}: '${short(letters[i].textContent)}' lies on '${short(over.textContent)}'`);
      const { left, right, top, bottom } = boxes[i];
      const beyond = left < -1 || top < -1 || right > frame.width + 1 || bottom > frame.height + 1;
      if (beyond) faults.push(`${name}: cut off, '${short(letters[i].textContent)}'`);
    }
    const scale = t => Math.hypot(t.getScreenCTM().a, t.getScreenCTM().b);
    const sizes = letters.map(t => parseFloat(getComputedStyle(t).fontSize) * scale(t));
    const least = Math.min(...sizes);
    if (least < smallest_letters) faults.push(`${name}: letters of ${least.toFixed(1)} px`);
  }
  return faults;
}

function open_frame(address, width) {
  const frame = document.createElement('iframe');
  frame.style.cssText = `border: 0; width: ${width}px; height: 900px`;
  return new Promise(done => {
    frame.onload = () => {
      const math = frame.contentWindow.MathJax;
      const ready = () => setTimeout(() => done(frame), 50);
      if (math && math.Hub) math.Hub.Register.StartupHook('End', ready);
      else ready();
    };
    frame.src = address;
    document.body.append(frame);
  });
}

async function look_at(name) {
  const frame = await open_frame(site + '/' + name, widths[0]);
  const page = frame.contentDocument;
  for (const folded of page.querySelectorAll('details')) folded.open = true;
  const found = [...restarted(page)];
  for (const width of widths) {
    frame.style.width = width + 'px';
    frame.style.height = page.documentElement.scrollHeight + 100 + 'px';
    await new Promise(done => setTimeout(done, 50));
    const faults = [...cut_off(page, width), ...covered(page), ...uneven(page), ...unreadable(page)];
    found.push(...faults.map(fault => `at ${width} px ${fault}`));
  }
  const bytes = new TextEncoder().encode(page.documentElement.outerHTML);
  let text = '';
  for (let i = 0; i < bytes.length; i += 8192) text += String.fromCharCode(...bytes.subarray(i, i + 8192));
  frame.remove();
  return [...found.map(fault => `fault\t${name}\t${fault}`), `page\t${name}\t${btoa(text)}`];
}

(async () => {
  for (const name of pages) {
    let said;
    try { said = await look_at(name); } catch (error) { said = [`broken\t${name}\t${error}`]; }
    document.getElementById('said').textContent += said.join('\n') + '\n';
  }
})();
