/** The bytes of a message between agent and simulator, and the connection that carries it. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.protocol.frame;
