/** Tests of the monitor client. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio.monitor;
