package org.robonewbie.studio;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.junit.jupiter.api.extension.ExtendWith;

/**
 * Opens one browser for all tests of a class, which take it as an argument of the constructor; without a browser on this
 * computer the tests are skipped. After each test it leaves the page, before the test closes its studio.
 */
@Target(ElementType.TYPE)
@Retention(RetentionPolicy.RUNTIME)
@ExtendWith(BrowserForTests.class)
@interface InBrowser {

    /** Width of the page in pixels. */
    int width() default 1366;

    /** Height of the page in pixels. */
    int height() default 768;
}
