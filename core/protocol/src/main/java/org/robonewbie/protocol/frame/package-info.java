/** What travels between agent and simulator: the bytes of one message, and the connection that carries it. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.protocol.frame;
