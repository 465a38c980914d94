/**
 * The robot for other simulators. Read {@link org.robonewbie.simulator.export.MjcfFile} first.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.export;
