/**
 * How an agent finds a simulator inside its own process without knowing it. Read {@link
 * org.robonewbie.protocol.embedded.SimulatorProvider} first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.protocol.embedded;
