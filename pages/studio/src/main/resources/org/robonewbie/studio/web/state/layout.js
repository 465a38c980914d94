/**
 * Layout of panels: columns side by side, each a stack of panels. Edges can be moved, panels can be collapsed to their titles. Pure.
 *
 * @typedef {'picture' | 'words' | 'curves' | 'joints' | 'surroundings' | 'code' | 'said'} PanelName
 * @typedef {{name: PanelName, part: number, folded: boolean}} Panel part is its fraction of the column when expanded
 * @typedef {{part: number, panels: readonly Panel[]}} Column part is its fraction of the width
 * @typedef {readonly Column[]} Layout
 * @typedef {'wide' | 'medium' | 'narrow'} Width
 * @typedef {'understand' | 'program'} PresetName
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

/** Gap between panels, with its margins wide enough for touch input. */
export const EDGE_PIXELS = 8;

/** Height of a collapsed panel. */
export const FOLDED_PIXELS = 34;

const MIN_PART = 0.12;
const WIDTHS = /** @type {const} */ ([
  ['narrow', 760],
  ['medium', 1180],
]);

/** @param {PanelName} name @param {number} part */
const open = (name, part) => ({ name, part, folded: false });

/** @param {PanelName} name @param {number} part */
const folded = (name, part) => ({ name, part, folded: true });

/** 3D view, plots, joints and messages together, to answer "why did it fall?" at a glance. @type {Record<Width, Layout>} */
export const UNDERSTAND = {
  wide: [
    { part: 0.45, panels: [open('picture', 0.64), open('words', 0.36)] },
    { part: 0.3, panels: [open('curves', 0.6), folded('surroundings', 0.4)] },
    { part: 0.25, panels: [open('joints', 1)] },
  ],
  medium: [
    { part: 0.56, panels: [open('picture', 0.62), open('words', 0.38)] },
    { part: 0.44, panels: [open('curves', 0.5), open('joints', 0.5), folded('surroundings', 0.5)] },
  ],
  narrow: [
    {
      part: 1,
      panels: [
        open('picture', 0.5),
        open('curves', 0.5),
        folded('words', 0.4),
        folded('joints', 0.4),
        folded('surroundings', 0.4),
      ],
    },
  ],
};

/** The program next to its robot. @type {Record<Width, Layout>} */
export const PROGRAM = {
  wide: [
    { part: 0.52, panels: [open('code', 1)] },
    { part: 0.48, panels: [open('picture', 0.68), open('said', 0.32)] },
  ],
  medium: [
    { part: 0.55, panels: [open('code', 1)] },
    { part: 0.45, panels: [open('picture', 0.62), open('said', 0.38)] },
  ],
  narrow: [{ part: 1, panels: [open('picture', 0.4), open('code', 0.6), folded('said', 0.3)] }],
};

/** Panels next to the 3D view, by preset. @type {Record<PresetName, Record<Width, Layout>>} */
export const LAYOUTS = { understand: UNDERSTAND, program: PROGRAM };

/** @param {number} pixels @returns {Width} the matching layout width */
export function widthOf(pixels) {
  return WIDTHS.find(([, minPixels]) => pixels < minPixels)?.[0] ?? 'wide';
}

/**
 * Restores a stored layout.
 *
 * @param {unknown} kept
 * @param {Width} width
 * @param {PresetName} [preset]
 * @returns {Layout} the stored layout, or the default if it does not contain each panel exactly once
 */
export function restoredLayout(kept, width, preset = 'understand') {
  const defaultLayout = LAYOUTS[preset][width];
  const columns = Array.isArray(kept) ? kept : [];
  const panels = columns.flatMap((column) => (Array.isArray(column?.panels) ? column.panels : []));
  const names = panels.map((panel) => String(panel?.name)).sort();
  const parts = [...columns, ...panels].map((each) => each?.part);
  const isWhole = names.join() === namesOf(defaultLayout).join();
  const isSound = columns.length === defaultLayout.length && parts.every((part) => part > 0 && part <= 1);
  return isWhole && isSound ? columns : defaultLayout;
}

/** @param {Layout} layout */
function namesOf(layout) {
  return layout.flatMap(({ panels }) => panels.map(({ name }) => name)).sort();
}

/**
 * Collapses or expands a panel.
 *
 * @param {Layout} layout
 * @param {PanelName} name
 * @returns {Layout}
 */
export function toggled(layout, name) {
  return layout.map((column) => ({
    ...column,
    panels: column.panels.map((panel) => (panel.name === name ? { ...panel, folded: !panel.folded } : panel)),
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
    return withParts(layout, column, column + 1, by);
  }
  const { panels } = layout[column];
  const [above, below] = neighbours(panels, panel);
  const whole = panels.reduce((sum, each) => sum + (each.folded ? 0 : each.part), 0);
  const moved = withParts(panels, above, below, by * whole);
  return layout.map((each, i) => (i === column ? { ...each, panels: moved } : each));
}

/**
 * @template {{part: number}} T
 * @param {readonly T[]} list
 * @param {number} first
 * @param {number} second
 * @param {number} by
 * @returns {readonly T[]}
 */
function withParts(list, first, second, by) {
  if (!list[first] || !list[second]) {
    return list;
  }
  const both = list[first].part + list[second].part;
  const minPixels = Math.min(MIN_PART, both / 2);
  const part = Math.max(minPixels, Math.min(both - minPixels, list[first].part + by));
  return list.map((each, i) =>
    i === first ? { ...each, part } : i === second ? { ...each, part: both - part } : each,
  );
}

/**
 * Returns the nearest expanded panels above and below an edge; -1 if there is none.
 *
 * @param {readonly Panel[]} panels @param {number} panel
 */
function neighbours(panels, panel) {
  const above = panels.findLastIndex((each, i) => i <= panel && !each.folded);
  return [above, panels.findIndex((each, i) => i > panel && !each.folded)];
}

/**
 * Computes the boxes of all panels and edges.
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
  const usable = width - EDGE_PIXELS * (layout.length - 1);
  const whole = layout.reduce((sum, { part }) => sum + part, 0);
  let left = 0;
  layout.forEach(({ part, panels }, column) => {
    const wide = (part / whole) * usable;
    placeColumn(panels, { left, top: 0, width: wide, height }, column, boxes, edges);
    left += wide;
    if (column < layout.length - 1) {
      const box = { left, top: 0, width: EDGE_PIXELS, height };
      const label = `Edge right of ${PANEL_TITLES[panels[0].name]}`;
      edges.push({ box, column, panel: undefined, percent: Math.round((100 * left) / width), label });
      left += EDGE_PIXELS;
    }
  });
  return { boxes, edges };
}

/** @param {readonly Panel[]} panels @param {Box} place @param {number} column @param {Map<PanelName, Box>} boxes @param {Edge[]} edges */
function placeColumn(panels, place, column, boxes, edges) {
  const opened = panels.filter(({ folded: isFolded }) => !isFolded);
  const fixed = EDGE_PIXELS * (panels.length - 1) + FOLDED_PIXELS * (panels.length - opened.length);
  const whole = opened.reduce((sum, { part }) => sum + part, 0);
  let { top } = place;
  panels.forEach(({ name, part, folded: isFolded }, panel) => {
    const height = isFolded ? FOLDED_PIXELS : Math.max(0, ((place.height - fixed) * part) / whole);
    boxes.set(name, { ...place, top, height });
    top += height;
    const [above, below] = neighbours(panels, panel);
    if (above >= 0 && below >= 0) {
      const box = { ...place, top, height: EDGE_PIXELS };
      const percent = Math.round((100 * top) / place.height);
      edges.push({ box, column, panel, percent, label: `Edge below ${PANEL_TITLES[name]}` });
    }
    top += EDGE_PIXELS;
  });
}
