/** Opens the 3D view of the pitch, or explains what to do if the browser does not support WebGL. */
import { byId } from '../panels/elements.js';
import { showBanner } from '../panels/messages.js';
import { QualityChooser, qualityRange } from '../state/quality.js';
import { FieldView } from './field-view.js';

/** @param {FieldView} view @param {number} asked index of the quality requested by the address, negative for none */
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
    showBanner({
      tone: 'trouble',
      title: 'This browser does not support 3D graphics',
      text: 'Switch on WebGL (hardware acceleration) in its settings, or open this address in another browser.',
    });
    throw error;
  }
}
