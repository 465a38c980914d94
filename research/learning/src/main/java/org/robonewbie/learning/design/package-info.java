/**
 * How each motion of the library was made. Read {@link org.robonewbie.learning.design.MotionDesign} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.learning.design;
