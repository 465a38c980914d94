/**
 * How an agent finds a simulator in its own process without depending on it. Read {@link
 * org.robonewbie.protocol.embedded.SimulatorProvider} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.protocol.embedded;
