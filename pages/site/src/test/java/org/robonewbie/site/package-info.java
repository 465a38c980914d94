/** Tests of the site generator, on this project and on small ones. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.site;
