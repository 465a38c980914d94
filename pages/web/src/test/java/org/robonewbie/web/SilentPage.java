package org.robonewbie.web;

import org.robonewbie.studio.PageFeed;

/** A page that discards everything. */
final class SilentPage implements PageFeed.Page {

    @Override
    public void send(String json) {
        // discarded
    }

    @Override
    public void show(byte[] frame) {
        // discarded
    }

    @Override
    public void keep(String note) {
        // discarded
    }
}
