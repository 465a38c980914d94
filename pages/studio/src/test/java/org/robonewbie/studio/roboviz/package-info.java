/** Tests of drawings in RoboViz's protocol. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio.roboviz;
