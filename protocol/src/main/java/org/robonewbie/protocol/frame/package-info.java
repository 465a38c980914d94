/** How messages travel: length-prefixed frames over TCP, or the same bytes inside one process. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.protocol.frame;
