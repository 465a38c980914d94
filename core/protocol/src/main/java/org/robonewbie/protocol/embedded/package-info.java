/**
 * Interfaces through which an agent uses a simulator in its own process without depending on the simulator module. Read {@link
 * org.robonewbie.protocol.embedded.SimulatorProvider} first.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.protocol.embedded;
