'use strict';
(() => {
  const data = JSON.parse(document.getElementById('data').textContent);
  const css = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  const dashes = [[], [7, 4], [2, 3], [9, 3, 2, 3]];
  const several = data.runs.length > 1;
  const plots = [];
  const sync = uPlot.sync('curves');
  let following = false;

  const number = v => v == null ? '–' : v === 0 ? '0'
      : (Math.abs(v) >= 1e6 || Math.abs(v) < 1e-4 ? v.toExponential(5) : String(+v.toPrecision(7)))
          .replace(/-/g, '−');
  const colour = curve => () => css('--c' + curve.colour % 8);
  const dash = curve => dashes[(several ? Math.max(0, curve.run - 1) : Math.floor(curve.colour / 8)) % 4];
  // The first of several runs is broad and pale, so that others along it do not hide it.
  const broad = curve => several && curve.run === 0;
  const look = curve => ({width: broad(curve) ? 4.8 : 1.6, alpha: broad(curve) ? 0.35 : 1});
  const label = curve => several ? curve.name + ', ' + data.runs[curve.run] : curve.name;

  // Tables of the runs of a panel as uPlot takes them: one x, one array a curve.
  function aligned(panel) {
    const runs = [...new Set(panel.curves.map(c => c.run))];
    const tables = runs.map(run => [data.tables[run][0],
        ...panel.curves.filter(c => c.run === run).map(c => data.tables[run][c.column])]);
    const order = runs.flatMap(run => panel.curves.filter(c => c.run === run));
    return {order, columns: tables.length === 1 ? tables[0] : uPlot.join(tables)};
  }

  function line(u, s) {
    const [xs, ys] = u.data[s];
    const path = new Path2D();
    let drawing = false;
    for (let i = 0; i < xs.length; i++) {
      if (xs[i] == null || ys[i] == null) {
        drawing = false;
        continue;
      }
      const x = u.valToPos(xs[i], 'x', true), y = u.valToPos(ys[i], 'y', true);
      if (drawing) path.lineTo(x, y); else path.moveTo(x, y);
      drawing = true;
    }
    const scale = u.series[s];
    u.ctx.save();
    u.ctx.beginPath();
    u.ctx.rect(u.bbox.left, u.bbox.top, u.bbox.width, u.bbox.height);
    u.ctx.clip();
    u.ctx.strokeStyle = scale.curveColour();
    u.ctx.lineWidth = scale.curveLook.width * devicePixelRatio;
    u.ctx.globalAlpha = scale.curveLook.alpha;
    u.ctx.setLineDash(scale.curveDash.map(d => d * devicePixelRatio));
    u.ctx.stroke(path);
    u.ctx.restore();
    return null;
  }

  // Leaves 4 % of the range free; a constant gets room around it.
  function padded(values) {
    let low = Infinity, high = -Infinity;
    for (const column of values) {
      for (const v of column) {
        if (v != null) {
          low = Math.min(low, v);
          high = Math.max(high, v);
        }
      }
    }
    if (low > high) return [0, 1];
    const room = high > low ? 0.04 * (high - low) : Math.abs(high) * 0.1 || 1;
    return [low - room, high + room];
  }

  function options(panel, width, height) {
    const axis = (title, side) => ({
      stroke: () => css('--muted'), grid: {stroke: () => css('--grid'), width: 1},
      ticks: {stroke: () => css('--axis'), width: 1, size: 5}, label: title, labelSize: 24,
      font: '12px Helvetica, Arial, sans-serif', labelFont: '13px Helvetica, Arial, sans-serif',
      values: (u, splits) => splits.map(v => v == null ? '' : number(v)),
      size: side ? (u, values) => Math.max(48, 16 + 7.5 * Math.max(0, ...(values || []).map(v => v.length)))
          : 40,
    });
    const shared = {
      width, height, axes: [axis(data.x, false), axis(panel.title, true)],
      hooks: {setScale: [(u, key) => {
        if (key !== 'x' || following) return;
        following = true;
        const {min, max} = u.scales.x;
        plots.filter(p => p !== u).forEach(p => p.setScale('x', {min, max}));
        following = false;
      }]},
    };
    if (data.inTime) {
      return {...shared, scales: {x: {time: false}},
        cursor: {sync: {key: sync.key}, drag: {x: true, y: false}}};
    }
    return {...shared, mode: 2, legend: {show: false},
      scales: {
        x: {time: false, range: (u, low, high) => u.zoomed ? [low, high] : padded(u.data.slice(1).map(d => d[0]))},
        y: {range: (u, low, high) => u.zoomed ? [low, high] : padded(u.data.slice(1).map(d => d[1]))},
      },
      cursor: {dataIdx: () => null, points: {show: false}, drag: {x: true, y: true},
        bind: {dblclick: u => () => { u.zoomed = false; redraw(u); }}},
      hooks: {
        setSelect: [u => { u.zoomed = true; }],
        setCursor: [u => { u.readOut.textContent = u.cursor.left < 0 ? '' :
            data.x + ' ' + number(u.posToVal(u.cursor.left, 'x')) + ', '
            + panel.title + ' ' + number(u.posToVal(u.cursor.top, 'y')); }],
      }};
  }

  function redraw(u) {
    u.setData(u.data, true);
  }

  function show(panel, at) {
    const place = document.getElementById('panel-' + at);
    const height = data.panels.length === 1 ? 440 : 260;
    const size = () => place.clientWidth;
    let u;
    if (data.inTime) {
      const {order, columns} = aligned(panel);
      u = new uPlot({...options(panel, size(), height), series: [
        {label: data.xName, value: (s, v) => number(v)},
        ...order.map(c => ({label: label(c), stroke: colour(c), dash: dash(c), ...look(c), pxAlign: 0,
          points: {show: columns[0].length < 2}, value: (s, v) => number(v)})),
      ]}, columns, place);
    } else {
      const key = document.createElement('p');
      panel.curves.forEach(c => {
        const name = document.createElement('span');
        name.style.color = 'var(--c' + c.colour % 8 + ')';
        name.style.marginRight = '18px';
        name.textContent = '— ' + label(c);
        key.append(name);
      });
      const readOut = document.createElement('p');
      readOut.setAttribute('aria-live', 'off');
      readOut.textContent = '\u00a0';
      u = new uPlot({...options(panel, size(), height), series: [{},
        ...panel.curves.map(c => ({facets: [{scale: 'x', auto: true}, {scale: 'y', auto: true}],
          curveColour: colour(c), curveDash: dash(c), curveLook: look(c), paths: line, points: {show: false}})),
      ]}, [null, ...panel.curves.map(c => [data.tables[c.run][0], data.tables[c.run][c.column]])],
      (self, init) => { self.readOut = readOut; place.append(self.root); init(); });
      place.append(key, readOut);
    }
    plots.push(u);
    new ResizeObserver(() => u.setSize({width: size(), height})).observe(place);
    if (data.inTime) {
      place.addEventListener('keydown', e => {
        const steps = {ArrowLeft: -1, ArrowRight: 1, PageUp: -20, PageDown: 20};
        if (!(e.key in steps)) return;
        const xs = u.data[0];
        const next = Math.max(0, Math.min(xs.length - 1, (u.cursor.idx ?? 0) + steps[e.key]));
        u.setCursor({left: u.valToPos(xs[next], 'x'), top: 10});
        e.preventDefault();
      });
    }
  }

  function whole() {
    plots.forEach(u => { u.zoomed = false; redraw(u); });
  }

  data.panels.forEach(show);
  document.getElementById('whole').addEventListener('click', whole);
  addEventListener('keydown', e => { if (e.key === 'Escape') whole(); });
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change',
      () => plots.forEach(u => u.redraw(false, true)));
})();
