/** Tests of the site: that of the project itself, and small ones. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.site;
