/**
 * Drawings in the RoboViz protocol (UDP port 32769). Start with {@link org.robonewbie.studio.roboviz.RoboVizPort}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio.roboviz;
