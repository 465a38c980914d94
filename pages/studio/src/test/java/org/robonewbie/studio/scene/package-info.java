/** Tests of saved scenes and undo. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio.scene;
