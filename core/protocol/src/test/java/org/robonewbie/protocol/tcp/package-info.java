/** Tests of connections over TCP. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.protocol.tcp;
