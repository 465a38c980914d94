/**
 * Layout of panels: columns side by side, each a stack of panels. Edges can be moved, and panels can be hidden. Pure.
 *
 * @typedef {'picture' | 'words' | 'curves' | 'joints' | 'surroundings' | 'code' | 'said'} PanelName
 * @typedef {{name: PanelName, part: number, isHidden: boolean}} Panel `part` is the fraction of the column
 * @typedef {{part: number, panels: readonly Panel[]}} Column `part` is the fraction of the width
 * @typedef {readonly Column[]} Layout
 * @typedef {'wide' | 'medium' | 'narrow'} Width
 * @typedef {Exclude<import('../panels/rooms.js').RoomName, 'motion'>} PanelRoom room with panels around the 3D view
 *
 * @typedef {{left: number, top: number, width: number, height: number}} Box pixels
 * @typedef {object} Edge handle between two columns or two panels
 * @property {Box} box
 * @property {number} column index of the column to its left, or of the column that contains it
 * @property {number | undefined} panel index of the panel above it; undefined between columns
 * @property {number} percent position within the divided area
 * @property {string} label
 */

/** Titles of the panels. @type {Record<PanelName, string>} */
export const PANEL_TITLES = {
  picture: 'Picture',
  words: 'Log and messages',
  curves: 'Curves',
  joints: 'Joints',
  surroundings: 'Surroundings and senses',
  code: 'Program',
  said: 'Output',
};

/** Gap between panels; with its margins, it is wide enough for touch input. */
export const EDGE_PIXELS = 8;

const MIN_PART = 0.12;
const WIDTHS = /** @type {const} */ ([
  ['narrow', 760],
  ['medium', 1180],
]);

/** @param {PanelName} name @param {number} part */
const shown = (name, part) => ({ name, part, isHidden: false });

/** @param {PanelName} name @param {number} part */
const hidden = (name, part) => ({ name, part, isHidden: true });

/** 3D view, plots, joints and messages together, to answer "why did it fall?" at a glance. @type {Record<Width, Layout>} */
const ROBOT = {
  wide: [
    { part: 0.45, panels: [shown('picture', 0.64), shown('words', 0.36)] },
    { part: 0.3, panels: [shown('surroundings', 0.6), shown('curves', 0.4)] },
    { part: 0.25, panels: [shown('joints', 1)] },
  ],
  medium: [
    { part: 0.5, panels: [shown('picture', 0.4), shown('curves', 0.4), shown('words', 0.2)] },
    { part: 0.5, panels: [shown('surroundings', 0.55), shown('joints', 0.45)] },
  ],
  narrow: [
    {
      part: 1,
      panels: [
        shown('picture', 0.5),
        shown('curves', 0.5),
        hidden('words', 0.4),
        hidden('joints', 0.4),
        hidden('surroundings', 0.4),
      ],
    },
  ],
};

/** The program next to its robot. @type {Record<Width, Layout>} */
const PROGRAM = {
  wide: [
    { part: 0.52, panels: [shown('code', 1)] },
    { part: 0.48, panels: [shown('picture', 0.68), shown('said', 0.32)] },
  ],
  medium: [
    { part: 0.55, panels: [shown('code', 1)] },
    { part: 0.45, panels: [shown('picture', 0.62), shown('said', 0.38)] },
  ],
  narrow: [{ part: 1, panels: [shown('picture', 0.4), shown('code', 0.6), hidden('said', 0.3)] }],
};

/** @param {PanelRoom} room @param {Width} width @returns {Layout} the default layout of a room */
export function defaultLayout(room, width) {
  const layout = (room === 'program' ? PROGRAM : ROBOT)[width];
  return room === 'program' || room === 'robot' ? layout : pictureOnly(layout);
}

/** @param {Layout} layout @returns {Layout} */
function pictureOnly(layout) {
  return layout.map((column) => ({
    ...column,
    panels: column.panels.map((panel) => ({ ...panel, isHidden: panel.name !== 'picture' })),
  }));
}

/** @param {number} pixels @returns {Width} the matching layout width */
export function widthOf(pixels) {
  return WIDTHS.find(([, minPixels]) => pixels < minPixels)?.[0] ?? 'wide';
}

/**
 * Restores a stored layout.
 *
 * @param {unknown} kept
 * @param {PanelRoom} room
 * @param {Width} width
 * @returns {Layout} the stored layout, or the default if it does not contain each panel exactly once
 */
export function restoredLayout(kept, room, width) {
  const standard = defaultLayout(room, width);
  const columns = Array.isArray(kept) ? kept : [];
  const panels = columns.flatMap((column) => (Array.isArray(column?.panels) ? column.panels : []));
  const names = panels.map((panel) => String(panel?.name)).sort();
  const parts = [...columns, ...panels].map((each) => each?.part);
  const isWhole = names.join() === panelsOf(standard).sort().join();
  const isSound = columns.length === standard.length && parts.every((part) => part > 0 && part <= 1);
  return isWhole && isSound ? columns : standard;
}

/** @param {Layout} layout @returns {PanelName[]} the names of all panels */
export function panelsOf(layout) {
  return layout.flatMap(({ panels }) => panels.map(({ name }) => name));
}

/** @param {Layout} layout @param {PanelName} name @returns {boolean} */
export function shows(layout, name) {
  return layout.some(({ panels }) => panels.some((panel) => panel.name === name && isShown(panel)));
}

/** @param {Column | Panel} part @returns {boolean} */
function isShown(part) {
  return 'panels' in part ? part.panels.some(isShown) : !part.isHidden;
}

/**
 * Shows or hides a panel.
 *
 * @param {Layout} layout
 * @param {PanelName} name
 * @returns {Layout}
 */
export function toggled(layout, name) {
  return layout.map((column) => ({
    ...column,
    panels: column.panels.map((panel) => (panel.name === name ? { ...panel, isHidden: isShown(panel) } : panel)),
  }));
}

/**
 * @param {Layout} layout
 * @param {Pick<Edge, 'column' | 'panel'>} edge
 * @param {number} by fraction of the whole width or height; positive to the right and down
 * @returns {Layout}
 */
export function withEdgeMoved(layout, { column, panel }, by) {
  if (panel === undefined) {
    return withParts(layout, column, by);
  }
  return layout.map((each, i) => (i === column ? { ...each, panels: withParts(each.panels, panel, by) } : each));
}

/**
 * Moves the edge between an entry and the next visible one.
 *
 * @template {Column | Panel} T
 * @param {readonly T[]} list
 * @param {number} first
 * @param {number} by fraction of the visible entries
 * @returns {readonly T[]}
 */
function withParts(list, first, by) {
  const second = list.findIndex((each, i) => i > first && isShown(each));
  if (!list[first] || second < 0) {
    return list;
  }
  const whole = wholeOf(list.filter(isShown));
  const both = list[first].part + list[second].part;
  const minPart = Math.min(MIN_PART * whole, both / 2);
  const part = Math.max(minPart, Math.min(both - minPart, list[first].part + by * whole));
  return list.map((each, i) =>
    i === first ? { ...each, part } : i === second ? { ...each, part: both - part } : each,
  );
}

/** @param {ReadonlyArray<{part: number}>} list */
function wholeOf(list) {
  return list.reduce((sum, { part }) => sum + part, 0);
}

/**
 * Computes the boxes of all visible panels and their edges.
 *
 * @param {Layout} layout
 * @param {number} width pixels
 * @param {number} height
 * @returns {{boxes: Map<PanelName, Box>, edges: Edge[]}}
 */
export function placed(layout, width, height) {
  /** @type {Map<PanelName, Box>} */
  const boxes = new Map();
  /** @type {Edge[]} */
  const edges = [];
  for (const column of divided(layout, width)) {
    const panels = divided(column.entry.panels, height);
    const box = { left: column.start, top: 0, width: column.size, height };
    for (const { entry, index, start, size, end } of panels) {
      boxes.set(entry.name, { ...box, top: start, height: size });
      if (end !== undefined) {
        const edge = { ...box, top: end, height: EDGE_PIXELS };
        edges.push(edgeOf(edge, column.index, index, end / height, `Edge below ${PANEL_TITLES[entry.name]}`));
      }
    }
    if (column.end !== undefined) {
      const edge = { ...box, left: column.end, width: EDGE_PIXELS };
      const label = `Edge right of ${PANEL_TITLES[panels[0].entry.name]}`;
      edges.push(edgeOf(edge, column.index, undefined, column.end / width, label));
    }
  }
  return { boxes, edges };
}

/** @param {Box} box @param {number} column @param {number | undefined} panel @param {number} part @param {string} label @returns {Edge} */
function edgeOf(box, column, panel, part, label) {
  return { box, column, panel, percent: Math.round(100 * part), label };
}

/**
 * Divides a length among the visible entries of a list, with an edge between neighbours.
 *
 * @template {Column | Panel} T
 * @param {readonly T[]} list
 * @param {number} length pixels
 * @returns {Array<{entry: T, index: number, start: number, size: number, end: number | undefined}>} end: start of the edge after it
 */
function divided(list, length) {
  const entries = [...list.entries()].filter(([, entry]) => isShown(entry));
  const usable = length - EDGE_PIXELS * (entries.length - 1);
  const whole = wholeOf(list.filter(isShown));
  let next = 0;
  return entries.map(([index, entry], i) => {
    const start = next;
    const size = (entry.part / whole) * usable;
    next += size + EDGE_PIXELS;
    return { entry, index, start, size, end: i < entries.length - 1 ? start + size : undefined };
  });
}
