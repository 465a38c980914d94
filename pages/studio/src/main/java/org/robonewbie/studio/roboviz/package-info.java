/**
 * Takes what teams draw for RoboViz: datagrams of its drawing protocol (UDP port 32769). Read {@link
 * org.robonewbie.studio.roboviz.RoboVizPort} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio.roboviz;
