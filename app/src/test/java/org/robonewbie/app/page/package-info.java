/** The programs and commands on the pages of the documentation run. */
package org.robonewbie.app.page;
