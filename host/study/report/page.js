'use strict';
// Draws one study: data are those of `report_data` in report.cpp.
const data = JSON.parse(document.getElementById('data').textContent);
const by = (id) => document.getElementById(id);
const colours = ['#0072b2', '#d55e00', '#009e73', '#cc79a7', '#e69f00', '#56b4e9', '#000000', '#8c8c8c', '#7f3c8d', '#a5aa00'];
const shapes = ['circle', 'rect', 'triangle', 'rectRot', 'star'];
const dashes = [[], [8, 4], [2, 3], [8, 3, 2, 3], [14, 4]];
const labels = [...new Set(data.lines.map((line) => line.label))];
const look = new Map(data.lines.map((line) => [line.label, { colour: colours[line.colour], shape: shapes[line.mark], dash: dashes[line.mark] }]));
const shown = new Set(labels);
const chosen = { case: data.cases[0] && data.cases[0].name, error: 0, against: 'cost' };
let chart = null;

const element = (name, text, attributes = {}) => {
  const made = document.createElement(name);
  if (text !== undefined) made.textContent = text;
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  return made;
};
const number = (value) => value === null ? '-' : Number(value.toPrecision(3)).toString();
const across = () => chosen.against === 'cost' ? data.cost : { name: 'particles', key: 'particles' };
const has = (point) => point.errors[chosen.error] > 0 && point[chosen.against] > 0;
const lines = () => data.lines.filter((line) => line.case === chosen.case);
const front = () => new Set(((data.fronts[chosen.case] || [])[chosen.error] || []).map(([line, point]) => data.lines[line].points[point]));

function describe(line, point) {
  const box = element('div');
  box.append(element('strong', line.label));
  const rows = [...point.settings];
  data.errors.forEach((error, k) => rows.push([error.name, number(point.errors[k])]));
  const spread = point.repeats > 1 ? ` (${number(point.cost_low)} to ${number(point.cost_high)} in ${point.repeats} runs)` : '';
  rows.push([data.cost.name, number(point.cost) + spread], ['particles', point.particles], ['steps', point.steps], ['state', point.state]);
  if (point.message) rows.push(['why', point.message]);
  const table = element('table');
  for (const [name, value] of rows) {
    const row = element('tr');
    row.append(element('td', name), element('td', value));
    table.append(row);
  }
  box.append(table, element('code', point.command));
  return box;
}

function open(line, point) {
  by('picture-words').replaceChildren(describe(line, point));
  const image = by('picture-image');
  image.hidden = !point.picture;
  if (point.picture) image.src = point.picture;
  by('picture').hidden = false;
}

function tip(context) {
  const box = by('tip');
  const item = (context.tooltip.dataPoints || []).find((one) => one.dataset.points);
  if (context.tooltip.opacity === 0 || !item) { box.hidden = true; return; }
  box.replaceChildren(describe(item.dataset.line, item.dataset.points[item.dataIndex]));
  box.hidden = false;
  const canvas = context.chart.canvas.getBoundingClientRect();
  const left = canvas.left + window.scrollX + context.tooltip.caretX + 14;
  box.style.left = Math.max(0, Math.min(left, window.scrollX + document.documentElement.clientWidth - box.offsetWidth - 8)) + 'px';
  box.style.top = (canvas.top + window.scrollY + context.tooltip.caretY + 14) + 'px';
}

function datasets() {
  const sets = [];
  if (chosen.against === 'cost') {
    const best = [...front()].filter(has).map((point) => ({ x: point.cost, y: point.errors[chosen.error] }));
    sets.push({ label: 'Pareto front', data: best, showLine: true, borderColor: '#1a1a1a44', borderWidth: 7, pointRadius: 0, pointHitRadius: 0, order: 9 });
  }
  for (const line of lines()) {
    const style = look.get(line.label), points = line.points.filter(has);
    sets.push({
      label: line.label, line, points, hidden: !shown.has(line.label), showLine: true,
      data: points.map((point) => ({ x: point[chosen.against], y: point.errors[chosen.error] })),
      borderColor: style.colour, backgroundColor: style.colour, borderDash: style.dash, borderWidth: 1.5, pointStyle: style.shape,
      pointRadius: 4.5, pointHoverRadius: 7,
    });
  }
  return sets;
}

const axis = (text, values) => ({
  type: 'logarithmic', min: Math.min(...values) / 1.2, max: Math.max(...values) * 1.2, title: { display: true, text },
  ticks: { callback: (value) => /^[125]/.test(Number(value).toExponential()) ? number(value) : '' },
});

function draw() {
  by('tip').hidden = true;
  if (chart) chart.destroy();
  by('chart-box').hidden = data.errors.length === 0;
  if (data.errors.length === 0) return;
  const points = lines().flatMap((line) => line.points.filter(has));
  chart = new Chart(by('chart'), {
    type: 'scatter', data: { datasets: datasets() },
    options: {
      animation: false, maintainAspectRatio: false, responsive: true,
      interaction: { mode: 'nearest', intersect: true },
      scales: { x: axis(across().name, points.map((point) => point[chosen.against])),
        y: axis(data.errors[chosen.error].name, points.map((point) => point.errors[chosen.error])) },
      plugins: { legend: { display: false }, tooltip: { enabled: false, external: tip, filter: (item) => Boolean(item.dataset.points) } },
      onClick: (event, items) => {
        const item = items.find((one) => chart.data.datasets[one.datasetIndex].points);
        if (!item) return;
        const set = chart.data.datasets[item.datasetIndex];
        open(set.line, set.points[item.index]);
      },
    },
  });
}

function table(heads, rows) {
  const made = element('table'), head = element('tr');
  heads.forEach((text) => head.append(element('th', text)));
  made.append(head);
  for (const { cells, front: best, line, point } of rows) {
    const row = element('tr', undefined, best ? { class: 'front' } : {});
    for (const cell of cells) row.append(element('td', typeof cell === 'number' || cell === null ? number(cell) : cell, typeof cell === 'string' ? {} : { class: 'number' }));
    if (point) {
      row.dataset.point = '';
      row.addEventListener('click', () => open(line, point));
    }
    made.append(row);
  }
  return made;
}

function tables() {
  const box = by('tables'), parts = [], best = front();
  const heads = ['closure', 'resolution', ...data.errors.map((error) => error.name), data.cost.name, 'particles', 'state'];
  const rows = [];
  for (const line of lines()) {
    if (!shown.has(line.label)) continue;
    for (const point of line.points) {
      rows.push({ cells: [line.label, point.resolution, ...point.errors, point.cost, point.particles, point.state], front: best.has(point), line, point });
    }
  }
  parts.push(element('h2', 'All points (bold: the Pareto front)'), table(heads, rows));
  const relative = data.relative.filter((row) => row.case === chosen.case && row.error === chosen.error && shown.has(row.line));
  if (relative.length > 0) {
    parts.push(element('h2', `Against the baseline "${data.baseline}", as multiples of its value`));
    parts.push(table(['closure', "baseline's resolution", 'cost at equal error', 'error at equal cost'],
      relative.map((row) => ({ cells: [row.line, row.resolution, row.cost, row.equal_cost_error] }))));
  }
  const orders = lines().filter((line) => line.orders[chosen.error] !== null);
  if (orders.length > 0) {
    parts.push(element('h2', 'Order of convergence over all resolutions'));
    parts.push(table(['closure', 'order'], orders.map((line) => ({ cells: [line.label, line.orders[chosen.error]] }))));
  }
  if (data.skipped.length > 0) {
    parts.push(element('h2', 'Skipped as meaningless'));
    parts.push(table(['combination', 'why'], data.skipped.map((row) => ({ cells: [row.combination, row.reason] }))));
  }
  box.replaceChildren(...parts);
}

function select(label, options, change) {
  const made = element('label', label), list = element('select');
  options.forEach(([value, text]) => list.append(element('option', text, { value })));
  list.addEventListener('change', () => { change(list.value); refresh(); });
  made.append(list);
  by('choices').append(made);
  return list;
}

function closures() {
  by('closures').replaceChildren(...labels.map((label) => {
    const row = element('label'), box = element('input', undefined, { type: 'checkbox' });
    box.checked = shown.has(label);
    box.addEventListener('change', () => { if (box.checked) shown.add(label); else shown.delete(label); refresh(); });
    const swatch = element('span', undefined, { class: 'swatch' });
    swatch.style.background = look.get(label).colour;
    row.append(box, swatch, document.createTextNode(label));
    return row;
  }));
}

function refresh() { draw(); tables(); }
function switch_all(on) { labels.forEach((label) => on ? shown.add(label) : shown.delete(label)); closures(); refresh(); }

document.title = data.title;
by('title').textContent = data.title;
by('counts').textContent = data.counts;
if (data.cases.length > 1) select('Case', data.cases.map((one) => [one.name, one.title]), (value) => { chosen.case = value; });
if (data.errors.length > 1) select('Error', data.errors.map((error, k) => [k, error.name]), (value) => { chosen.error = Number(value); });
select('Against', [['cost', data.cost.name], ['particles', 'number of particles']], (value) => { chosen.against = value; }).id = 'against';
by('all').addEventListener('click', () => switch_all(true));
by('none').addEventListener('click', () => switch_all(false));
by('close').addEventListener('click', () => { by('picture').hidden = true; });
by('picture').addEventListener('click', (event) => { if (event.target === by('picture')) by('picture').hidden = true; });
document.addEventListener('keydown', (event) => { if (event.key === 'Escape') by('picture').hidden = true; });
closures();
refresh();
document.documentElement.dataset.ready = String(Math.round(performance.now()));
