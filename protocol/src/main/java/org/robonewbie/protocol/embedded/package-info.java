/**
 * How an agent finds a simulator in its own process without depending on it. Read {@link
 * org.robonewbie.protocol.embedded.SimulatorProvider} first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.protocol.embedded;
