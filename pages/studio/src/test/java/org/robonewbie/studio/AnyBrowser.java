package org.robonewbie.studio;

import com.google.gson.JsonElement;

/** What tests do alike in every browser. */
interface AnyBrowser {

    /** Opens an address and waits until its page is loaded. */
    void visit(String address);

    /** Evaluates an expression in the page; a promise is waited for. */
    JsonElement evaluate(String expression);

    /** Waits until a condition holds in the page. */
    void await(String condition);

    /** Clicks an element. */
    void click(String selector);
}
