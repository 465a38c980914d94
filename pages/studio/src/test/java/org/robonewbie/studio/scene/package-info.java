/** Tests of what can be undone. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio.scene;
