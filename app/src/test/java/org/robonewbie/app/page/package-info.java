/** The programs and commands on the pages of the documentation run. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.app.page;
