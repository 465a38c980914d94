/**
 * How each motion of the library was made. Read {@link org.robonewbie.learning.design.MotionDesign} first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.learning.design;
