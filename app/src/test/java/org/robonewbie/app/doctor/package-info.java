/** Tests of the checks of the installation. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.app.doctor;
