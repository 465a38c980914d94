/** Tests of message buffers. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.protocol.frame;
