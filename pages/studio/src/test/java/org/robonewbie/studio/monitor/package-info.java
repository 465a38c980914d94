/** Tests of the package that watches other servers. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio.monitor;
