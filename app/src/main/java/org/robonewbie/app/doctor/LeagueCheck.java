package org.robonewbie.app.doctor;

import org.robonewbie.studio.league.LeagueServer;

/** Looks for RCSSServerMJ, which only programs with the option {@code --robot} need. */
final class LeagueCheck {

    private LeagueCheck() {}

    static Finding server() {
        String found = LeagueServer.find()
                .map(command -> "found at " + command)
                .orElse("not installed; only \"--robot T1\" and \"--robot K1\" need it (" + LeagueServer.INSTALLATION
                        + ")");
        return Finding.well("RCSSServerMJ", found);
    }
}
