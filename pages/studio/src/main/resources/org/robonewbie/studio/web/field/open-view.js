/** Opens the picture of the pitch, and says what to do where a browser has no third dimension. */
import { byId } from '../panels/elements.js';
import { tell } from '../panels/messages.js';
import { QualityChooser, qualityRange } from '../state/quality.js';
import { FieldView } from './field-view.js';

/** @param {FieldView} view @param {number} asked the quality that the address asks for, negative if none */
export function chooserFor(view, asked) {
  const isFixed = asked >= 0;
  const range = isFixed ? { first: asked, highest: asked } : qualityRange(view.graphics);
  const chooser = new QualityChooser(range, isFixed);
  if (!isFixed) {
    view.setQuality(chooser.quality);
  }
  return chooser;
}

/** @param {import('../state/quality.js').Quality} quality */
export function openView(quality) {
  try {
    return new FieldView(byId('stage'), quality);
  } catch (error) {
    tell({
      tone: 'trouble',
      title: 'This browser does not draw in three dimensions',
      text: 'Switch on WebGL (hardware acceleration) in its settings, or open this address in another browser.',
    });
    throw error;
  }
}
