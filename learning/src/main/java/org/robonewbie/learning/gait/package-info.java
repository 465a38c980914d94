/**
 * Steps as keyframes: converts positions of the feet to angles of the legs. Read {@link org.robonewbie.learning.gait.Footsteps}
 * first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.learning.gait;
