/** Tests over real sockets, a real world and a real browser. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio;
