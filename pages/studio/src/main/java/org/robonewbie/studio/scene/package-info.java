/**
 * Continues the simulation from a moment that was kept: a saved scene or any cycle of a recording. Read {@link
 * org.robonewbie.studio.scene.SceneService} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio.scene;
