/** Tests of drawings in the protocol of RoboViz. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio.roboviz;
