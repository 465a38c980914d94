/** Tests of message frames and connections. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.protocol.frame;
