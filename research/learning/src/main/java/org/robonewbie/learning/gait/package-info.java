/**
 * Steps as keyframes: converts positions of the feet to angles of the legs. Read {@link org.robonewbie.learning.gait.Footsteps}
 * first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.learning.gait;
