package org.robonewbie.studio;

import com.google.gson.JsonElement;

/** Browser operations that tests use in every browser. */
interface AnyBrowser {

    /** Opens an address and waits until its page has loaded. */
    void visit(String address);

    /** Evaluates an expression in the page; awaits a promise. */
    JsonElement evaluate(String expression);

    /** Waits until a condition holds in the page. */
    void await(String condition);

    void click(String selector);
}
