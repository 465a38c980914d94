package org.robonewbie.studio;

import java.io.IOException;
import java.io.UncheckedIOException;
import org.junit.jupiter.api.extension.AfterTestExecutionCallback;
import org.junit.jupiter.api.extension.BeforeAllCallback;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.extension.ExtensionContext.Namespace;
import org.junit.jupiter.api.extension.ParameterContext;
import org.junit.jupiter.api.extension.ParameterResolver;

/** Lends the browser of {@link InBrowser}; JUnit closes it after the last test of the class. */
final class BrowserForTests implements BeforeAllCallback, AfterTestExecutionCallback, ParameterResolver {

    @Override
    public void beforeAll(ExtensionContext context) {
        Tool.BROWSER.orSkip();
        browser(context);
    }

    @Override
    public void afterTestExecution(ExtensionContext context) {
        browser(context).evaluate("(() => { try { localStorage.clear(); } catch { return; } })()");
        browser(context).visit("about:blank");
        browser(context).forgetComplaints();
    }

    @Override
    public boolean supportsParameter(ParameterContext parameter, ExtensionContext context) {
        return parameter.getParameter().getType() == Chromium.class;
    }

    @Override
    public Chromium resolveParameter(ParameterContext parameter, ExtensionContext context) {
        return browser(context);
    }

    private static Chromium browser(ExtensionContext context) {
        InBrowser wanted = context.getRequiredTestClass().getAnnotation(InBrowser.class);
        return context.getStore(Namespace.create(BrowserForTests.class, context.getRequiredTestClass()))
                .computeIfAbsent(Chromium.class, type -> open(wanted), Chromium.class);
    }

    private static Chromium open(InBrowser wanted) {
        try {
            return Chromium.open(wanted.width(), wanted.height());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
