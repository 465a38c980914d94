@org.jspecify.annotations.NullMarked
package org.robonewbie.app.command;
