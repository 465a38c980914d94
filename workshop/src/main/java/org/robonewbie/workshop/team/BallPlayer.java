package org.robonewbie.workshop.team;

import org.robonewbie.agent.Agent;
import org.robonewbie.agent.perception.CameraTransformation;
import org.robonewbie.team.skill.Footwork;
import org.robonewbie.team.skill.Gaze;
import org.robonewbie.team.skill.Kick;
import org.robonewbie.team.skill.KickKind;
import org.robonewbie.team.skill.Limbs;
import org.robonewbie.team.world.WorldModel;

/** Robot that kicks the ball straight along the pitch like the players of the example team. */
final class BallPlayer extends Agent {

    private final WorldModel world = new WorldModel();
    private final Limbs body = new Limbs(nao, walk, motions, lookAround);
    private final Footwork feet = new Footwork(walk);
    private final Kick kick;
    private final Gaze gaze = new Gaze(body);
    private boolean begun;

    BallPlayer(KickKind kind) {
        kick = new Kick(body, feet, kind);
        fieldView.setTransformation(CameraTransformation.KINEMATICS);
        walk.setStyle(Footwork.STYLE);
    }

    @Override
    protected void think() {
        world.update(nao, fieldView);
        gaze.look(world);
        begun = begun || motions.start("stand"); // as every player does after beaming, before the match
        if (motions.isFinished() && Double.isFinite(world.ballAgeSeconds())) {
            kick.kick(world, 0);
        }
    }
}
