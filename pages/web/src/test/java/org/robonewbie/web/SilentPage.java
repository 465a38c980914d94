package org.robonewbie.web;

import org.robonewbie.studio.PageFeed;

/** A page that nobody looks at. */
final class SilentPage implements PageFeed.Page {

    @Override
    public void tell(String json) {
        // nobody hears it
    }

    @Override
    public void show(byte[] frame) {
        // nobody sees it
    }

    @Override
    public void keep(String note) {
        // nobody reads it
    }
}
