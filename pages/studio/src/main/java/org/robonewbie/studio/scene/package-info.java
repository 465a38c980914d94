/**
 * Continues the simulation from a saved scene or from any cycle of a recording. Start with {@link
 * org.robonewbie.studio.scene.SceneService}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio.scene;
