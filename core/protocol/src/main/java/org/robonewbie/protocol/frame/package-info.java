/** Message buffers, and the connections that carry messages between agent and simulator. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.protocol.frame;
