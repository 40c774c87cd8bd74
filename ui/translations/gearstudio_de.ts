<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
 <context>
  <name>GearStudio</name>
  <message>
   <source> (+ {count} beside)</source>
   <translation> (+ {count} daneben)</translation>
  </message>
  <message>
   <source> and </source>
   <translation> und </translation>
  </message>
  <message>
   <source> or </source>
   <translation> oder </translation>
  </message>
  <message>
   <source>&amp;About GearStudio</source>
   <translation>&amp;Über GearStudio</translation>
  </message>
  <message>
   <source>&amp;Back</source>
   <translation>&amp;Zurück</translation>
  </message>
  <message>
   <source>&amp;Backups…</source>
   <translation>S&amp;icherungen…</translation>
  </message>
  <message>
   <source>&amp;Cancel</source>
   <translation>A&amp;bbrechen</translation>
  </message>
  <message>
   <source>&amp;Clear the list</source>
   <translation>Liste &amp;leeren</translation>
  </message>
  <message>
   <source>&amp;Copy</source>
   <translation>&amp;Kopieren</translation>
  </message>
  <message>
   <source>&amp;Copy picture and numbers</source>
   <translation>Bild und Zahlen &amp;kopieren</translation>
  </message>
  <message>
   <source>&amp;Differences only</source>
   <translation>Nur &amp;Unterschiede</translation>
  </message>
  <message>
   <source>&amp;Discard recovered</source>
   <translation>&amp;Wiederhergestelltes verwerfen</translation>
  </message>
  <message>
   <source>&amp;Display panel</source>
   <translation>&amp;Darstellung</translation>
  </message>
  <message>
   <source>&amp;Done</source>
   <translation>&amp;Fertig</translation>
  </message>
  <message>
   <source>&amp;Edit</source>
   <translation>&amp;Bearbeiten</translation>
  </message>
  <message>
   <source>&amp;Equations</source>
   <translation>&amp;Gleichungen</translation>
  </message>
  <message>
   <source>&amp;Export…</source>
   <translation>&amp;Exportieren…</translation>
  </message>
  <message>
   <source>&amp;File</source>
   <translation>&amp;Datei</translation>
  </message>
  <message>
   <source>&amp;Film…</source>
   <translation>Fil&amp;m…</translation>
  </message>
  <message>
   <source>&amp;Find a parameter</source>
   <translation>Parameter &amp;finden</translation>
  </message>
  <message>
   <source>&amp;Full screen</source>
   <translation>&amp;Vollbild</translation>
  </message>
  <message>
   <source>&amp;Generating line on</source>
   <translation>&amp;Erzeugende auf</translation>
  </message>
  <message>
   <source>&amp;Go back to this one</source>
   <translation>&amp;Zu diesem zurückkehren</translation>
  </message>
  <message>
   <source>&amp;Guide</source>
   <translation>&amp;Anleitung</translation>
  </message>
  <message>
   <source>&amp;Help</source>
   <translation>&amp;Hilfe</translation>
  </message>
  <message>
   <source>&amp;Keep this one</source>
   <translation>&amp;Diesen behalten</translation>
  </message>
  <message>
   <source>&amp;Keys…</source>
   <translation>&amp;Tasten…</translation>
  </message>
  <message>
   <source>&amp;Layers</source>
   <translation>&amp;Ebenen</translation>
  </message>
  <message>
   <source>&amp;Model</source>
   <translation>&amp;Modell</translation>
  </message>
  <message>
   <source>&amp;New</source>
   <translation>&amp;Neu</translation>
  </message>
  <message>
   <source>&amp;Next</source>
   <translation>&amp;Weiter</translation>
  </message>
  <message>
   <source>&amp;Open design…</source>
   <translation>Entwurf &amp;öffnen…</translation>
  </message>
  <message>
   <source>&amp;Open…</source>
   <translation>Ö&amp;ffnen…</translation>
  </message>
  <message>
   <source>&amp;Panels</source>
   <translation>&amp;Tafeln</translation>
  </message>
  <message>
   <source>&amp;Preferences…</source>
   <translation>&amp;Einstellungen…</translation>
  </message>
  <message>
   <source>&amp;Quit</source>
   <translation>&amp;Beenden</translation>
  </message>
  <message>
   <source>&amp;Rebuild</source>
   <translation>&amp;Neu aufbauen</translation>
  </message>
  <message>
   <source>&amp;Redo</source>
   <translation>&amp;Wiederholen</translation>
  </message>
  <message>
   <source>&amp;Report…</source>
   <translation>&amp;Bericht…</translation>
  </message>
  <message>
   <source>&amp;Reset layout</source>
   <translation>&amp;Anordnung zurücksetzen</translation>
  </message>
  <message>
   <source>&amp;Reset settings…</source>
   <translation>Einste&amp;llungen zurücksetzen…</translation>
  </message>
  <message>
   <source>&amp;Samples</source>
   <translation>&amp;Beispiele</translation>
  </message>
  <message>
   <source>&amp;Save</source>
   <translation>&amp;Speichern</translation>
  </message>
  <message>
   <source>&amp;Save PDF…</source>
   <translation>PDF &amp;speichern…</translation>
  </message>
  <message>
   <source>&amp;Save…</source>
   <translation>&amp;Speichern…</translation>
  </message>
  <message>
   <source>&amp;Show equation</source>
   <translation>Gl&amp;eichung zeigen</translation>
  </message>
  <message>
   <source>&amp;Stop</source>
   <translation>&amp;Anhalten</translation>
  </message>
  <message>
   <source>&amp;Take the file</source>
   <translation>Datei &amp;nehmen</translation>
  </message>
  <message>
   <source>&amp;Theme</source>
   <translation>&amp;Farbschema</translation>
  </message>
  <message>
   <source>&amp;Tour</source>
   <translation>&amp;Rundgang</translation>
  </message>
  <message>
   <source>&amp;Undo</source>
   <translation>&amp;Rückgängig</translation>
  </message>
  <message>
   <source>&amp;Undock</source>
   <translation>&amp;Ablösen</translation>
  </message>
  <message>
   <source>&amp;Update preview</source>
   <translation>&amp;Vorschau erneuern</translation>
  </message>
  <message>
   <source>&amp;View</source>
   <translation>&amp;Ansicht</translation>
  </message>
  <message>
   <source>&amp;View all</source>
   <translation>Alles &amp;zeigen</translation>
  </message>
  <message>
   <source>&amp;What is this?</source>
   <translation>&amp;Was ist das?</translation>
  </message>
  <message>
   <source>, offset {offset} mm</source>
   <translation>, Achsversatz {offset} mm</translation>
  </message>
  <message>
   <source>1 problem</source>
   <translation>1 Problem</translation>
  </message>
  <message>
   <source>1 warning</source>
   <translation>1 Warnung</translation>
  </message>
  <message>
   <source>10/41 teeth with an offset of 38.1 mm, nearly a third of the wheel's radius</source>
   <translation>10/41 Zähne, Achsversatz 38,1 mm, fast ein Drittel des Radradius</translation>
  </message>
  <message>
   <source>11/41 teeth with an offset of 25.4 mm: a rear axle whose pinion lies below the wheel's axis</source>
   <translation>11/41 Zähne, Achsversatz 25,4 mm: Hinterachse, deren Ritzel unter der Radachse liegt</translation>
  </message>
  <message>
   <source>13/37 teeth with an offset of 15 mm and shafts at 80°</source>
   <translation>13/37 Zähne, Achsversatz 15 mm, Achsenwinkel 80°</translation>
  </message>
  <message>
   <source>13/42 teeth with an offset of −10 mm: the pinion's spiral angle is the smaller one, and its cone the slimmer</source>
   <translation>13/42 Zähne, Achsversatz −10 mm: das Ritzel hat den kleineren Spiralwinkel und den schlankeren Kegel</translation>
  </message>
  <message>
   <source>14/35 teeth at 110°: a nearly flat wheel, and the same spiral angle everywhere on the face</source>
   <translation>14/35 Zähne bei 110°: ein fast flaches Rad, überall auf der Breite derselbe Spiralwinkel</translation>
  </message>
  <message>
   <source>14/39 teeth after ISO 23509: the same depth from toe to heel, for gears that one cutter head finishes</source>
   <translation>14/39 Zähne nach ISO 23509: gleiche Höhe von Zehe bis Ferse, für Räder, die ein Messerkopf fertigt</translation>
  </message>
  <message>
   <source>15/45 teeth, 28° spiral everywhere, sphere ends as in the paper</source>
   <translation>15/45 Zähne, überall 28° Spirale, Zahnenden auf Kugeln wie in der Arbeit</translation>
  </message>
  <message>
   <source>16/32 teeth without spiral: teeth on straight lines to the apex, long and short addendum</source>
   <translation>16/32 Zähne ohne Spirale: Zähne auf Geraden zur Spitze, ungleiche Kopfhöhen</translation>
  </message>
  <message>
   <source>17/40 teeth at 90° with a cutter arc of 80 mm and 35° spiral; the pinion's root lies inside its base cone</source>
   <translation>17/40 Zähne bei 90°, Messerkreisradius 80 mm, 35° Spirale; der Fuß des Ritzels liegt im Grundkegel</translation>
  </message>
  <message>
   <source>18/27 teeth at 45°: slender cones, long cone distance</source>
   <translation>18/27 Zähne bei 45°: schlanke Kegel, große Kegellänge</translation>
  </message>
  <message>
   <source>19/43 teeth of module 20 mm, outer cone distance near half a metre</source>
   <translation>19/43 Zähne mit Modul 20 mm, äußere Teilkegellänge fast ein halber Meter</translation>
  </message>
  <message>
   <source>20/60 teeth of module 0.5 mm</source>
   <translation>20/60 Zähne mit Modul 0,5 mm</translation>
  </message>
  <message>
   <source>25/50 teeth curved by the cutter, but with no spiral angle at the mean point; shaft angle 75°</source>
   <translation>25/50 Zähne, vom Messerkopf gekrümmt, aber im Mittelpunkt ohne Spiralwinkel; Achsenwinkel 75°</translation>
  </message>
  <message>
   <source>3D</source>
   <translation>3D</translation>
  </message>
  <message>
   <source>3D views drawn by</source>
   <translation>3D-Ansichten durch</translation>
  </message>
  <message>
   <source>3MF unit</source>
   <translation>3MF-Einheit</translation>
  </message>
  <message>
   <source>7 × 7 points inside the flank: root to tip, then on towards the heel</source>
   <translation>7 × 7 Punkte in der Flanke: vom Fuß zum Kopf, dann weiter zur Ferse</translation>
  </message>
  <message>
   <source>9/37 teeth on a wheel of 420 mm with an offset of 40 mm; teeth of a tapering depth with a tilted root line</source>
   <translation>9/37 Zähne, Rad 420 mm, Achsversatz 40 mm; sich verjüngende Zähne mit geneigter Fußlinie</translation>
  </message>
  <message>
   <source>: not measured</source>
   <translation>: nicht gemessen</translation>
  </message>
  <message>
   <source>; equation {printed} of the paper</source>
   <translation>; Gleichung {printed} der Arbeit</translation>
  </message>
  <message>
   <source>A NURBS surface through discrete points on U and V lines</source>
   <translation>Eine NURBS-Fläche durch einzelne Punkte auf U- und V-Linien</translation>
  </message>
  <message>
   <source>A circle on the sphere, tangent to root and flank (or to the meridian below the base cone); it scales with ρ. The paper's factor f is 0.3.</source>
   <translation>Ein Kreis auf der Kugel, tangential an Fuß und Flanke (unter dem Grundkegel an den Meridian); er wächst mit ρ. Der Faktor f der Arbeit ist 0,3.</translation>
  </message>
  <message>
   <source>A click shows this method and variant; Ctrl+C copies the rows chosen</source>
   <translation>Ein Klick zeigt Methode und Variante; Strg+C kopiert die gewählten Zeilen</translation>
  </message>
  <message>
   <source>A cube too, from where it ends down to the flank's lower edge; a_r is the share of the depth there.</source>
   <translation>Ebenfalls eine dritte Potenz, von ihrem Ende hinab zum unteren Rand der Flanke; a_r ist der Anteil der Höhe dort.</translation>
  </message>
  <message>
   <source>A cube, so that slope and curvature have no kink where it starts; a_t is the share of the depth there.</source>
   <translation>Eine dritte Potenz, damit Steigung und Krümmung am Beginn keinen Knick haben; a_t ist der Anteil der Höhe dort.</translation>
  </message>
  <message>
   <source>A few letters are enough; Up and Down choose, Enter carries out</source>
   <translation>Wenige Buchstaben genügen; Auf und Ab wählen, Enter führt aus</translation>
  </message>
  <message>
   <source>A mark shows where the paper prints something else</source>
   <translation>Eine Marke zeigt, wo in der Arbeit etwas anderes steht</translation>
  </message>
  <message>
   <source>A misprint under the root: the spherical right triangle gives cos²δ.</source>
   <translation>Druckfehler unter der Wurzel: das rechtwinklige Kugeldreieck gibt cos²δ.</translation>
  </message>
  <message>
   <source>A number above 0, at most {most}</source>
   <translation>Eine Zahl über 0, höchstens {most}</translation>
  </message>
  <message>
   <source>A part of GearStudio could not be loaded: {text}</source>
   <translation>Ein Teil von GearStudio konnte nicht geladen werden: {text}</translation>
  </message>
  <message>
   <source>A picture is missing: {reason}</source>
   <translation>Ein Bild fehlt: {reason}</translation>
  </message>
  <message>
   <source>A point is turned about the axis by as much as moves it by e along the flank's normal: the flank stays explicit in azimuth. The methods build this flank, and deviation is from it.</source>
   <translation>Ein Punkt wird so weit um die Achse gedreht, dass er sich um e entlang der Flankennormalen verschiebt: die Flanke bleibt explizit im Azimut. Die Methoden bauen diese Flanke, und die Abweichung zählt von ihr aus.</translation>
  </message>
  <message>
   <source>A point of the wheel's flank touches the pinion where its normal stands square to the relative velocity. That is linear in the cosine and the sine of its azimuth Φ: the envelope has a closed form.</source>
   <translation>Ein Punkt der Radflanke berührt das Ritzel, wo seine Normale rechtwinklig zur Relativgeschwindigkeit steht. Das ist linear in Kosinus und Sinus seines Azimuts Φ: die Einhüllende hat eine geschlossene Form.</translation>
  </message>
  <message>
   <source>A ratio that changes with n cannot be the count of points.</source>
   <translation>Ein Verhältnis, das sich mit n ändert, kann nicht die Punktzahl sein.</translation>
  </message>
  <message>
   <source>A rear-axle ratio with few pinion teeth: strong profile shift, constant clearance, a little backlash</source>
   <translation>Hinterachsübersetzung mit kleiner Ritzelzähnezahl: starke Profilverschiebung, gleichbleibendes Kopfspiel, etwas Flankenspiel</translation>
  </message>
  <message>
   <source>A reference: the pinion's flanks as involutes on base cones of their own</source>
   <translation>Zum Vergleich: Ritzelflanken als Evolventen auf eigenen Grundkegeln</translation>
  </message>
  <message>
   <source>A round length; in perspective, of what is in the middle</source>
   <translation>Eine runde Länge; in Perspektive gilt sie in der Mitte</translation>
  </message>
  <message>
   <source>A section at ρ is turned by θ(ρ). ψ_t is the tooth trace's polar angle in the developed pitch plane, 0 at the mean point: of an Archimedean spiral, of the cutter's arc or of a logarithmic spiral. The hand is +1 for a right-hand spiral; the mate has the other.</source>
   <translation>Ein Schnitt bei ρ ist um θ(ρ) gedreht. ψ_t ist der Polarwinkel der Flankenlinie in der abgewickelten Teilebene, 0 im Mittelpunkt: einer archimedischen Spirale, des Messerkopfbogens oder einer logarithmischen Spirale. Die Spiralrichtung „hand“ ist +1 für rechtssteigend; das Gegenrad hat die andere.</translation>
  </message>
  <message>
   <source>A square marks a corner or the middle of an edge near by; a click takes that point</source>
   <translation>Ein Quadrat zeigt eine Ecke oder Kantenmitte in der Nähe; ein Klick nimmt diesen Punkt</translation>
  </message>
  <message>
   <source>A turned copy is the same flank of another tooth.</source>
   <translation>Eine gedrehte Kopie ist dieselbe Flanke eines anderen Zahns.</translation>
  </message>
  <message>
   <source>A value with another unit can always be typed: 3in, {length}mm.</source>
   <translation>Ein Wert in einer anderen Einheit kann immer getippt werden: 3in, {length}mm.</translation>
  </message>
  <message>
   <source>AP203</source>
   <translation>AP203</translation>
  </message>
  <message>
   <source>AP214</source>
   <translation>AP214</translation>
  </message>
  <message>
   <source>AP242</source>
   <translation>AP242</translation>
  </message>
  <message>
   <source>AP242 is today's; AP214 and AP203 are for older programs</source>
   <translation>AP242 ist das heutige; AP214 und AP203 sind für ältere Programme</translation>
  </message>
  <message>
   <source>About GearStudio</source>
   <translation>Über GearStudio</translation>
  </message>
  <message>
   <source>About an axis through the centre of mass, square to the gear's axis</source>
   <translation>Um eine Achse durch den Schwerpunkt, rechtwinklig zur Radachse</translation>
  </message>
  <message>
   <source>About the gear's axis</source>
   <translation>Um die Radachse</translation>
  </message>
  <message>
   <source>Above this the CAD process is replaced when it is at rest; 0 for no limit</source>
   <translation>Darüber wird der CAD-Prozess in Ruhe ersetzt; 0 heißt unbegrenzt</translation>
  </message>
  <message>
   <source>Acute shafts</source>
   <translation>Spitzer Achsenwinkel</translation>
  </message>
  <message>
   <source>Addendum angle</source>
   <translation>Kopfwinkel</translation>
  </message>
  <message>
   <source>Addendum at the heel over outer module, before profile shift.</source>
   <translation>Kopfhöhe an der Ferse durch Außenmodul, vor der Profilverschiebung.</translation>
  </message>
  <message>
   <source>Addendum factor</source>
   <translation>Kopfhöhenfaktor</translation>
  </message>
  <message>
   <source>Addendum, heel</source>
   <translation>Kopfhöhe, Ferse</translation>
  </message>
  <message>
   <source>After a crash, edits since the last copy are lost</source>
   <translation>Nach einem Absturz fehlen die Änderungen seit der letzten Kopie</translation>
  </message>
  <message>
   <source>Against the effort</source>
   <translation>Über dem Aufwand</translation>
  </message>
  <message>
   <source>All can be told apart by colour-blind eyes</source>
   <translation>Alle sind auch bei Farbfehlsichtigkeit unterscheidbar</translation>
  </message>
  <message>
   <source>All files</source>
   <translation>Alle Dateien</translation>
  </message>
  <message>
   <source>All methods and variants in a table</source>
   <translation>Alle Methoden und Varianten in einer Tabelle</translation>
  </message>
  <message>
   <source>All parameters are good</source>
   <translation>Alle Parameter sind gut</translation>
  </message>
  <message>
   <source>All points</source>
   <translation>Alle Punkte</translation>
  </message>
  <message>
   <source>All points of the generating line share the azimuth a of the line of contact: the plane is a rigid body.</source>
   <translation>Alle Punkte der Erzeugenden haben das Azimut a der Berührlinie: die Ebene ist starr.</translation>
  </message>
  <message>
   <source>All teeth</source>
   <translation>Alle Zähne</translation>
  </message>
  <message>
   <source>All three</source>
   <translation>Alle drei</translation>
  </message>
  <message>
   <source>Along the axis, from the largest corner of the tip. t_z is how far the pitch apex lies beyond the crossing point; 0 without an offset.</source>
   <translation>Entlang der Achse, von der größten Kopfkante. t_z ist, wie weit die Teilkegelspitze über dem Kreuzungspunkt liegt; 0 ohne Achsversatz.</translation>
  </message>
  <message>
   <source>Along the face</source>
   <translation>Entlang der Breite</translation>
  </message>
  <message>
   <source>Along the face, at half the depth of the flank</source>
   <translation>Entlang der Breite, in halber Flankenhöhe</translation>
  </message>
  <message>
   <source>Along the pitch circle at the heel; in the normal section at the mean point; the chord of that, which a gear tooth caliper measures.</source>
   <translation>Auf dem Teilkreis an der Ferse; im Normalschnitt im Mittelpunkt; dessen Sehne, die ein Zahndickenmessschieber misst.</translation>
  </message>
  <message>
   <source>Along the profile</source>
   <translation>Entlang des Profils</translation>
  </message>
  <message>
   <source>Along the profile, at the middle of the face</source>
   <translation>Entlang des Profils, in der Mitte der Breite</translation>
  </message>
  <message>
   <source>Aluminium</source>
   <translation>Aluminium</translation>
  </message>
  <message>
   <source>Analysis</source>
   <translation>Auswertung</translation>
  </message>
  <message>
   <source>Angle at most</source>
   <translation>Winkel höchstens</translation>
  </message>
  <message>
   <source>Angle between pitch and base element</source>
   <translation>Winkel zwischen Teil- und Grundkegellinie</translation>
  </message>
  <message>
   <source>Angle between the two axes; both pitch cones must stay below 90°.</source>
   <translation>Winkel zwischen den Achsen; beide Teilkegel müssen unter 90° bleiben.</translation>
  </message>
  <message>
   <source>Another way to draw takes effect at the next start.</source>
   <translation>Eine andere Zeichenart gilt ab dem nächsten Start.</translation>
  </message>
  <message>
   <source>Apex at the origin, axis along +z, teeth at z &gt; 0.</source>
   <translation>Spitze im Ursprung, Achse entlang +z, Zähne bei z &gt; 0.</translation>
  </message>
  <message>
   <source>Archimedean miter pair</source>
   <translation>Archimedisches Gehrungspaar</translation>
  </message>
  <message>
   <source>Archimedean spiral</source>
   <translation>Archimedische Spirale</translation>
  </message>
  <message>
   <source>Archimedean: the paper's spiral on the base cone. Circular arc: the cutter's path. Logarithmic: the same spiral angle everywhere.</source>
   <translation>Archimedisch: die Spirale der Arbeit auf dem Grundkegel. Kreisbogen: die Bahn des Messerkopfs. Logarithmisch: überall derselbe Spiralwinkel.</translation>
  </message>
  <message>
   <source>Arcs of the tip and root circles between the flanks.</source>
   <translation>Bögen der Kopf- und Fußkreise zwischen den Flanken.</translation>
  </message>
  <message>
   <source>Area</source>
   <translation>Fläche</translation>
  </message>
  <message>
   <source>Area of the pinion's flank over that of the wheel's which generates it; 0 is a cusp, less than 0 undercut. The numbers are the smallest of both flanks, and where.</source>
   <translation>Fläche der Ritzelflanke durch die der Radflanke, die sie erzeugt; 0 ist eine Rückkehrkante, unter 0 ist Unterschnitt. Die Zahlen sind die kleinsten beider Flanken und ihr Ort.</translation>
  </message>
  <message>
   <source>Arrows along the normals of the CAD flanks</source>
   <translation>Pfeile entlang der Normalen der CAD-Flanken</translation>
  </message>
  <message>
   <source>As an azimuth on the pitch cone, with profile shift x and transverse backlash j_t.</source>
   <translation>Als Azimut auf dem Teilkegel, mit Profilverschiebung x und Verdrehflankenspiel j_t.</translation>
  </message>
  <message>
   <source>As it is</source>
   <translation>Wie sie ist</translation>
  </message>
  <message>
   <source>As made</source>
   <translation>Wie gemacht</translation>
  </message>
  <message>
   <source>As the paper has it, or refined until it meets the tolerance</source>
   <translation>Wie in der Arbeit, oder verfeinert bis zur Toleranz</translation>
  </message>
  <message>
   <source>As the standard's recursion has it</source>
   <translation>Wie in der Rekursion der Norm</translation>
  </message>
  <message>
   <source>As the system</source>
   <translation>Wie das System</translation>
  </message>
  <message>
   <source>As the theme</source>
   <translation>Wie das Schema</translation>
  </message>
  <message>
   <source>As they are computed, in the order of the theory; beside a bar what the paper prints where that differs.</source>
   <translation>So, wie sie gerechnet werden, in der Reihenfolge der Theorie; neben einem Balken steht, was die Veröffentlichung druckt, wo das abweicht.</translation>
  </message>
  <message>
   <source>As {format}</source>
   <translation>Als {format}</translation>
  </message>
  <message>
   <source>Assembled from its faces</source>
   <translation>Aus Flächen gefügt</translation>
  </message>
  <message>
   <source>Assign</source>
   <translation>Zuweisen</translation>
  </message>
  <message>
   <source>At a cone distance R'; θ_a and θ_f lie between pitch cone and face cone, and pitch cone and root cone.</source>
   <translation>Bei einer Kegellänge R'; θ_a und θ_f liegen zwischen Teil- und Kopfkegel, und zwischen Teil- und Fußkegel.</translation>
  </message>
  <message>
   <source>At the heel, square to the pitch cone; the profile shift x is the pinion's, the wheel has its negative.</source>
   <translation>An der Ferse, rechtwinklig zum Teilkegel; die Profilverschiebung x ist die des Ritzels, das Rad hat die entgegengesetzte.</translation>
  </message>
  <message>
   <source>At the mean point. With the outer module as depth system of a pair with an offset the factors are those that give the depths of the module at the wheel's heel.</source>
   <translation>Im Mittelpunkt. Mit dem Außenmodul als Zahnhöhensystem eines Paars mit Achsversatz sind es die Faktoren, die an der Ferse des Rads die Zahnhöhen aus dem Modul ergeben.</translation>
  </message>
  <message>
   <source>Auto</source>
   <translation>Auto</translation>
  </message>
  <message>
   <source>Automatic</source>
   <translation>Automatisch</translation>
  </message>
  <message>
   <source>Automatic range</source>
   <translation>Automatischer Bereich</translation>
  </message>
  <message>
   <source>Automotive 9/41</source>
   <translation>Fahrzeugachse 9/41</translation>
  </message>
  <message>
   <source>Axes</source>
   <translation>Achsen</translation>
  </message>
  <message>
   <source>Axial</source>
   <translation>Axial</translation>
  </message>
  <message>
   <source>Axial face width</source>
   <translation>Axiale Zahnbreite</translation>
  </message>
  <message>
   <source>Axial section of the blank; double-click to enlarge</source>
   <translation>Achsschnitt des Radkörpers; Doppelklick vergrößert</translation>
  </message>
  <message>
   <source>Axis of the section</source>
   <translation>Achse des Schnitts</translation>
  </message>
  <message>
   <source>Azimuth</source>
   <translation>Azimut</translation>
  </message>
  <message>
   <source>Azimuth, from where it started, of a point of the plane that rolls on the base cone without slip.</source>
   <translation>Azimut eines Punkts der Ebene, die ohne Gleiten auf dem Grundkegel rollt, vom Startort aus.</translation>
  </message>
  <message>
   <source>BREP as</source>
   <translation>BREP als</translation>
  </message>
  <message>
   <source>Back</source>
   <translation>Hinten</translation>
  </message>
  <message>
   <source>Back by a twelfth of a tooth</source>
   <translation>Um eine Zwölftelteilung zurück</translation>
  </message>
  <message>
   <source>Back cone: as blanks are turned. Sphere: as in the paper.</source>
   <translation>Rückenkegel: wie Radkörper gedreht werden. Kugel: wie in der Arbeit.</translation>
  </message>
  <message>
   <source>Back cones</source>
   <translation>Rückenkegel</translation>
  </message>
  <message>
   <source>Background of the views</source>
   <translation>Hintergrund der Ansichten</translation>
  </message>
  <message>
   <source>Backlash</source>
   <translation>Flankenspiel</translation>
  </message>
  <message>
   <source>Backups</source>
   <translation>Sicherungen</translation>
  </message>
  <message>
   <source>Base angle</source>
   <translation>Grundkegelwinkel</translation>
  </message>
  <message>
   <source>Base angle, coast flank</source>
   <translation>Grundkegelwinkel, Schubflanke</translation>
  </message>
  <message>
   <source>Base angle, drive flank</source>
   <translation>Grundkegelwinkel, Zugflanke</translation>
  </message>
  <message>
   <source>Base cone</source>
   <translation>Grundkegel</translation>
  </message>
  <message>
   <source>Base cone angle</source>
   <translation>Winkel des Grundkegels</translation>
  </message>
  <message>
   <source>Base cone spiral</source>
   <translation>Spirale auf dem Grundkegel</translation>
  </message>
  <message>
   <source>Base radius</source>
   <translation>Grundradius</translation>
  </message>
  <message>
   <source>Base radius, heel</source>
   <translation>Grundradius, Ferse</translation>
  </message>
  <message>
   <source>Base-cone spiral</source>
   <translation>Grundkegelspirale</translation>
  </message>
  <message>
   <source>Best fit</source>
   <translation>Beste Einpassung</translation>
  </message>
  <message>
   <source>Between normals</source>
   <translation>Zwischen Normalen</translation>
  </message>
  <message>
   <source>Bevel pair of uniform depth</source>
   <translation>Kegelradpaar mit gleich hohen Zähnen</translation>
  </message>
  <message>
   <source>Bias</source>
   <translation>Verwindung</translation>
  </message>
  <message>
   <source>Binary is five times smaller, text can be read</source>
   <translation>Binär ist fünfmal kleiner, Text ist lesbar</translation>
  </message>
  <message>
   <source>Binary is smaller and quicker, text can be read</source>
   <translation>Binär ist kleiner und schneller, Text ist lesbar</translation>
  </message>
  <message>
   <source>Black</source>
   <translation>Schwarz</translation>
  </message>
  <message>
   <source>Blank of the {member}</source>
   <translation>Radkörper: {member}</translation>
  </message>
  <message>
   <source>Blanks</source>
   <translation>Radkörper</translation>
  </message>
  <message>
   <source>Blue – orange</source>
   <translation>Blau – Orange</translation>
  </message>
  <message>
   <source>Borders of the flanks</source>
   <translation>Ränder der Flanken</translation>
  </message>
  <message>
   <source>Bore diameter</source>
   <translation>Bohrungs-Ø</translation>
  </message>
  <message>
   <source>Both are the same.</source>
   <translation>Beide sind gleich.</translation>
  </message>
  <message>
   <source>Both cones touch at the mean point; ζ_m is the offset angle about the wheel's axis, ζ_mp that in the pitch plane. One number is left free, which the limit radius closes.</source>
   <translation>Beide Kegel berühren sich im Mittelpunkt; ζ_m ist der Versatzwinkel um die Radachse, ζ_mp der in der Teilebene. Eine Zahl bleibt frei; der Grenzradius legt sie fest.</translation>
  </message>
  <message>
   <source>Both flanks as the method made them, in one colour</source>
   <translation>Beide Flanken, wie die Methode sie machte, in einer Farbe</translation>
  </message>
  <message>
   <source>Both members</source>
   <translation>Beide Räder</translation>
  </message>
  <message>
   <source>Both members have the same normal module, but not the same transverse one.</source>
   <translation>Beide Räder haben denselben Normalmodul, aber nicht denselben Stirnmodul.</translation>
  </message>
  <message>
   <source>Brass</source>
   <translation>Messing</translation>
  </message>
  <message>
   <source>Bronze</source>
   <translation>Bronze</translation>
  </message>
  <message>
   <source>Browse…</source>
   <translation>Wählen…</translation>
  </message>
  <message>
   <source>Build</source>
   <translation>Bauen</translation>
  </message>
  <message>
   <source>Build &amp;gear</source>
   <translation>&amp;Rad bauen</translation>
  </message>
  <message>
   <source>Build &amp;pair</source>
   <translation>Radp&amp;aar bauen</translation>
  </message>
  <message>
   <source>Build both gears and show them in mesh</source>
   <translation>Beide Räder bauen und im Eingriff zeigen</translation>
  </message>
  <message>
   <source>Build each method with growing effort; the design may be edited meanwhile</source>
   <translation>Jede Methode mit wachsendem Aufwand bauen; der Entwurf bleibt änderbar</translation>
  </message>
  <message>
   <source>Build every variant again</source>
   <translation>Jede Variante neu bauen</translation>
  </message>
  <message>
   <source>Build the solid of the design as it is now</source>
   <translation>Den Körper des jetzigen Entwurfs bauen</translation>
  </message>
  <message>
   <source>Build the solids anew after every edit</source>
   <translation>Die Körper nach jeder Änderung neu bauen</translation>
  </message>
  <message>
   <source>Build the whole gear as a solid and show it</source>
   <translation>Das ganze Rad als Körper bauen und zeigen</translation>
  </message>
  <message>
   <source>Building alone, both flanks</source>
   <translation>Nur das Bauen, beide Flanken</translation>
  </message>
  <message>
   <source>Building and checking</source>
   <translation>Bauen und Prüfen</translation>
  </message>
  <message>
   <source>Building the {member} as a solid</source>
   <translation>Körper wird gebaut: {member}</translation>
  </message>
  <message>
   <source>Building {method}, {variant}</source>
   <translation>{method}, {variant} wird gebaut</translation>
  </message>
  <message>
   <source>Built in</source>
   <translation>Gebaut in</translation>
  </message>
  <message>
   <source>CAD flanks</source>
   <translation>CAD-Flanken</translation>
  </message>
  <message>
   <source>CAD flanks coloured by deviation or curvature</source>
   <translation>CAD-Flanken, gefärbt nach Abweichung oder Krümmung</translation>
  </message>
  <message>
   <source>CAD kernel busy</source>
   <translation>CAD-Kern arbeitet</translation>
  </message>
  <message>
   <source>CAD kernel ready</source>
   <translation>CAD-Kern bereit</translation>
  </message>
  <message>
   <source>CAD kernel restarting…</source>
   <translation>CAD-Kern startet neu…</translation>
  </message>
  <message>
   <source>CAD kernel starting…</source>
   <translation>CAD-Kern startet…</translation>
  </message>
  <message>
   <source>CAD kernel stopped</source>
   <translation>CAD-Kern angehalten</translation>
  </message>
  <message>
   <source>CAD surface</source>
   <translation>CAD-Fläche</translation>
  </message>
  <message>
   <source>CSV, .dat, or columns x y z and, if there are, nx ny nz, in mm; or a STEP file of the gear</source>
   <translation>CSV, .dat oder Spalten x y z und wahlweise nx ny nz in mm; oder eine STEP-Datei des Rads</translation>
  </message>
  <message>
   <source>Can be selected and copied</source>
   <translation>Kann gewählt und kopiert werden</translation>
  </message>
  <message>
   <source>Cancel</source>
   <translation>Abbrechen</translation>
  </message>
  <message>
   <source>Cancelled; Build builds it</source>
   <translation>Abgebrochen; Bauen baut ihn</translation>
  </message>
  <message>
   <source>Cancelled; Rebuild builds it</source>
   <translation>Abgebrochen; Neu aufbauen baut sie</translation>
  </message>
  <message>
   <source>Cast iron</source>
   <translation>Gusseisen</translation>
  </message>
  <message>
   <source>Centre along face</source>
   <translation>Mitte längs der Breite</translation>
  </message>
  <message>
   <source>Centre on profile</source>
   <translation>Mitte im Profil</translation>
  </message>
  <message>
   <source>Centre z</source>
   <translation>Zentrum z</translation>
  </message>
  <message>
   <source>Change {field} to {value}</source>
   <translation>{field} auf {value} ändern</translation>
  </message>
  <message>
   <source>Chapters</source>
   <translation>Kapitel</translation>
  </message>
  <message>
   <source>Chart</source>
   <translation>Diagramm</translation>
  </message>
  <message>
   <source>Charts</source>
   <translation>Diagramme</translation>
  </message>
  <message>
   <source>Choose a command to change its keys</source>
   <translation>Befehl wählen, um seine Tasten zu ändern</translation>
  </message>
  <message>
   <source>Choose a design</source>
   <translation>Entwurf wählen</translation>
  </message>
  <message>
   <source>Choose a design to compare with the one that is open.</source>
   <translation>Einen Entwurf zum Vergleich mit dem offenen wählen.</translation>
  </message>
  <message>
   <source>Choose a file format</source>
   <translation>Dateiformat wählen</translation>
  </message>
  <message>
   <source>Choose a folder</source>
   <translation>Ordner wählen</translation>
  </message>
  <message>
   <source>Choose another colour for this layer</source>
   <translation>Eine andere Farbe für diese Ebene wählen</translation>
  </message>
  <message>
   <source>Choose what goes in, then Update preview.</source>
   <translation>Inhalt wählen, dann Vorschau erneuern.</translation>
  </message>
  <message>
   <source>Chordal addendum, mean</source>
   <translation>Höhe über der Sehne, Mitte</translation>
  </message>
  <message>
   <source>Chordal addendum, outer</source>
   <translation>Höhe über der Sehne, außen</translation>
  </message>
  <message>
   <source>Circular arc (milled)</source>
   <translation>Kreisbogen (gefräst)</translation>
  </message>
  <message>
   <source>Circular plane of radius R that rolls on the base cone</source>
   <translation>Kreisebene mit Radius R, die auf dem Grundkegel rollt</translation>
  </message>
  <message>
   <source>Clear</source>
   <translation>Leeren</translation>
  </message>
  <message>
   <source>Clear where nothing is; for slides and papers</source>
   <translation>Durchsichtig, wo nichts ist; für Folien und Aufsätze</translation>
  </message>
  <message>
   <source>Clearance</source>
   <translation>Kopfspiel</translation>
  </message>
  <message>
   <source>Clearance factor</source>
   <translation>Kopfspielfaktor</translation>
  </message>
  <message>
   <source>Clearance over depth</source>
   <translation>Kopfspiel zu Zahnhöhe</translation>
  </message>
  <message>
   <source>Click into a table first</source>
   <translation>Erst in eine Tabelle klicken</translation>
  </message>
  <message>
   <source>Click the second point.</source>
   <translation>Den zweiten Punkt anklicken.</translation>
  </message>
  <message>
   <source>Click to see it in the view.</source>
   <translation>Klicken zeigt es in der Ansicht.</translation>
  </message>
  <message>
   <source>Click two points of the solid.</source>
   <translation>Zwei Punkte des Körpers anklicken.</translation>
  </message>
  <message>
   <source>Click two points: their distance and what lies between</source>
   <translation>Zwei Punkte anklicken: ihr Abstand und was dazwischen liegt</translation>
  </message>
  <message>
   <source>Close</source>
   <translation>Schließen</translation>
  </message>
  <message>
   <source>Close the display panel</source>
   <translation>Darstellungstafel schließen</translation>
  </message>
  <message>
   <source>Close the report</source>
   <translation>Bericht schließen</translation>
  </message>
  <message>
   <source>Close without writing</source>
   <translation>Schließen, ohne zu schreiben</translation>
  </message>
  <message>
   <source>Close; every choice is already in force</source>
   <translation>Schließen; alles gilt schon</translation>
  </message>
  <message>
   <source>Close; nothing changes</source>
   <translation>Schließen; nichts ändert sich</translation>
  </message>
  <message>
   <source>Close; what is being painted is given up</source>
   <translation>Schließen; was gerade gezeichnet wird, entfällt</translation>
  </message>
  <message>
   <source>Closed</source>
   <translation>Geschlossen</translation>
  </message>
  <message>
   <source>Co&amp;mpare with design…</source>
   <translation>&amp;Mit Entwurf vergleichen…</translation>
  </message>
  <message>
   <source>Coarse</source>
   <translation>Grob</translation>
  </message>
  <message>
   <source>Coarse mill drive</source>
   <translation>Grober Mühlenantrieb</translation>
  </message>
  <message>
   <source>Coast</source>
   <translation>Schub</translation>
  </message>
  <message>
   <source>Colour and opacity of {layer}</source>
   <translation>Farbe und Deckkraft: {layer}</translation>
  </message>
  <message>
   <source>Colour of the layer</source>
   <translation>Farbe der Ebene</translation>
  </message>
  <message>
   <source>Colour scale</source>
   <translation>Farbskala</translation>
  </message>
  <message>
   <source>Coloured flanks</source>
   <translation>Gefärbte Flanken</translation>
  </message>
  <message>
   <source>Colours</source>
   <translation>Farben</translation>
  </message>
  <message>
   <source>Colours of the members and of their flanks</source>
   <translation>Farben der Räder und ihrer Flanken</translation>
  </message>
  <message>
   <source>Colours of the window</source>
   <translation>Farben des Fensters</translation>
  </message>
  <message>
   <source>Colours, surface quality, cameras and ground of the views</source>
   <translation>Farben, Flächengüte, Kameras und Grund der Ansichten</translation>
  </message>
  <message>
   <source>Colour…</source>
   <translation>Farbe…</translation>
  </message>
  <message>
   <source>Combs</source>
   <translation>Kämme</translation>
  </message>
  <message>
   <source>Command</source>
   <translation>Befehl</translation>
  </message>
  <message>
   <source>Command &amp;palette…</source>
   <translation>&amp;Befehle suchen…</translation>
  </message>
  <message>
   <source>Command or parameter</source>
   <translation>Befehl oder Parameter</translation>
  </message>
  <message>
   <source>Command palette</source>
   <translation>Befehlssuche</translation>
  </message>
  <message>
   <source>Commands</source>
   <translation>Befehle</translation>
  </message>
  <message>
   <source>Commands and their keys</source>
   <translation>Befehle und ihre Tasten</translation>
  </message>
  <message>
   <source>Commands found</source>
   <translation>Gefundene Befehle</translation>
  </message>
  <message>
   <source>Common apex</source>
   <translation>Gemeinsame Spitze</translation>
  </message>
  <message>
   <source>Common apex: all cones share the apex, as in the paper. Constant clearance: the tip runs parallel to the mate's root.</source>
   <translation>Gemeinsame Spitze: alle Kegel haben dieselbe Spitze, wie in der Arbeit. Gleichbleibendes Kopfspiel: der Kopf läuft parallel zum Fuß des Gegenrads.</translation>
  </message>
  <message>
   <source>Compare designs</source>
   <translation>Entwürfe vergleichen</translation>
  </message>
  <message>
   <source>Compare with design</source>
   <translation>Mit Entwurf vergleichen</translation>
  </message>
  <message>
   <source>Compare with the design of a file</source>
   <translation>Mit dem Entwurf einer Datei vergleichen</translation>
  </message>
  <message>
   <source>Comparison</source>
   <translation>Vergleich</translation>
  </message>
  <message>
   <source>Comparison of all methods and variants</source>
   <translation>Vergleich aller Methoden und Varianten</translation>
  </message>
  <message>
   <source>Compound</source>
   <translation>Paste</translation>
  </message>
  <message>
   <source>Compute the report of the design as it is now</source>
   <translation>Den Bericht des jetzigen Entwurfs berechnen</translation>
  </message>
  <message>
   <source>Computed</source>
   <translation>Berechnet</translation>
  </message>
  <message>
   <source>Concave</source>
   <translation>Konkav</translation>
  </message>
  <message>
   <source>Concave flank</source>
   <translation>Konkave Flanke</translation>
  </message>
  <message>
   <source>Cones</source>
   <translation>Kegel</translation>
  </message>
  <message>
   <source>Conjugate</source>
   <translation>Konjugiert</translation>
  </message>
  <message>
   <source>Constant clearance</source>
   <translation>Konstantes Kopfspiel</translation>
  </message>
  <message>
   <source>Constant slot width</source>
   <translation>Gleichbleibende Lückenweite</translation>
  </message>
  <message>
   <source>Construction</source>
   <translation>Aufbau</translation>
  </message>
  <message>
   <source>Contact</source>
   <translation>Kontakt</translation>
  </message>
  <message>
   <source>Contact pattern</source>
   <translation>Tragbild</translation>
  </message>
  <message>
   <source>Contact pattern and transmission error, with misalignments</source>
   <translation>Tragbild und Drehwegabweichung, mit Einbaufehlern</translation>
  </message>
  <message>
   <source>Contact pattern on both members.</source>
   <translation>Tragbild auf beiden Rädern.</translation>
  </message>
  <message>
   <source>Contact pattern, ease-off and transmission error, drive and coast</source>
   <translation>Tragbild, Ease-off und Drehwegabweichung, Zug und Schub</translation>
  </message>
  <message>
   <source>Contact ratio</source>
   <translation>Überdeckung</translation>
  </message>
  <message>
   <source>Contact ratios</source>
   <translation>Überdeckungen</translation>
  </message>
  <message>
   <source>Contact ratios with an offset</source>
   <translation>Überdeckungen mit Achsversatz</translation>
  </message>
  <message>
   <source>Contour lines</source>
   <translation>Höhenlinien</translation>
  </message>
  <message>
   <source>Contours</source>
   <translation>Höhenlinien</translation>
  </message>
  <message>
   <source>Contours every {step} µm; 0 at the mean point</source>
   <translation>Höhenlinien alle {step} µm; 0 im Mittelpunkt</translation>
  </message>
  <message>
   <source>Control points of the heavier flank</source>
   <translation>Kontrollpunkte der aufwendigeren Flanke</translation>
  </message>
  <message>
   <source>Control points of the surface, u × v</source>
   <translation>Kontrollpunkte der Fläche, u × v</translation>
  </message>
  <message>
   <source>Convergence</source>
   <translation>Konvergenz</translation>
  </message>
  <message>
   <source>Convex</source>
   <translation>Konvex</translation>
  </message>
  <message>
   <source>Convex flank</source>
   <translation>Konvexe Flanke</translation>
  </message>
  <message>
   <source>Copied the chart: picture and numbers</source>
   <translation>Diagramm kopiert: Bild und Zahlen</translation>
  </message>
  <message>
   <source>Copied the data sheet as {format}</source>
   <translation>Datenblatt als {format} kopiert</translation>
  </message>
  <message>
   <source>Copied the numbers of the chart; paste them into a spreadsheet</source>
   <translation>Zahlen des Diagramms kopiert; in eine Tabellenkalkulation einfügen</translation>
  </message>
  <message>
   <source>Copied the picture of the chart</source>
   <translation>Bild des Diagramms kopiert</translation>
  </message>
  <message>
   <source>Copied; paste it into a spreadsheet</source>
   <translation>Kopiert; in eine Tabellenkalkulation einfügen</translation>
  </message>
  <message>
   <source>Copies of the last saves, with what was different</source>
   <translation>Kopien der letzten Stände, mit den Unterschieden</translation>
  </message>
  <message>
   <source>Copy</source>
   <translation>Kopieren</translation>
  </message>
  <message>
   <source>Copy &amp;derived values</source>
   <translation>&amp;Abgeleitete Werte kopieren</translation>
  </message>
  <message>
   <source>Copy &amp;diagnostics</source>
   <translation>&amp;Diagnose kopieren</translation>
  </message>
  <message>
   <source>Copy &amp;numbers</source>
   <translation>Za&amp;hlen kopieren</translation>
  </message>
  <message>
   <source>Copy &amp;picture</source>
   <translation>&amp;Bild kopieren</translation>
  </message>
  <message>
   <source>Copy &amp;table</source>
   <translation>&amp;Tabelle kopieren</translation>
  </message>
  <message>
   <source>Copy all of the report</source>
   <translation>Den ganzen Bericht kopieren</translation>
  </message>
  <message>
   <source>Copy co&amp;mparison</source>
   <translation>&amp;Vergleich kopieren</translation>
  </message>
  <message>
   <source>Copy of unsaved work after</source>
   <translation>Kopie ungesicherter Arbeit nach</translation>
  </message>
  <message>
   <source>Copy report</source>
   <translation>Bericht kopieren</translation>
  </message>
  <message>
   <source>Copy table</source>
   <translation>Tabelle kopieren</translation>
  </message>
  <message>
   <source>Copy the comparison table as text</source>
   <translation>Die Vergleichstabelle als Text kopieren</translation>
  </message>
  <message>
   <source>Copy the derived values as text</source>
   <translation>Die abgeleiteten Werte als Text kopieren</translation>
  </message>
  <message>
   <source>Copy the entries that are shown</source>
   <translation>Die gezeigten Einträge kopieren</translation>
  </message>
  <message>
   <source>Copy the message with its details</source>
   <translation>Die Meldung mit Einzelheiten kopieren</translation>
  </message>
  <message>
   <source>Copy the picture and the numbers</source>
   <translation>Bild und Zahlen kopieren</translation>
  </message>
  <message>
   <source>Copy the picture to the clipboard</source>
   <translation>Das Bild in die Zwischenablage kopieren</translation>
  </message>
  <message>
   <source>Copy the sheet</source>
   <translation>Datenblatt kopieren</translation>
  </message>
  <message>
   <source>Copy the table for a spreadsheet</source>
   <translation>Die Tabelle für eine Tabellenkalkulation kopieren</translation>
  </message>
  <message>
   <source>Copy the table with the focus, for a spreadsheet</source>
   <translation>Die Tabelle mit dem Fokus kopieren, für eine Tabellenkalkulation</translation>
  </message>
  <message>
   <source>Copy the values as a table</source>
   <translation>Die Werte als Tabelle kopieren</translation>
  </message>
  <message>
   <source>Copy versions, design and log for a report</source>
   <translation>Versionen, Entwurf und Protokoll für eine Meldung kopieren</translation>
  </message>
  <message>
   <source>Copy what is chosen in a table or text</source>
   <translation>Das in Tabelle oder Text Gewählte kopieren</translation>
  </message>
  <message>
   <source>Count</source>
   <translation>Anzahl</translation>
  </message>
  <message>
   <source>Crown to apex</source>
   <translation>Kopfkante zur Spitze</translation>
  </message>
  <message>
   <source>Crown to crossing point</source>
   <translation>Kopfkante zum Kreuzungspunkt</translation>
  </message>
  <message>
   <source>Curvature</source>
   <translation>Krümmung</translation>
  </message>
  <message>
   <source>Curvature combs</source>
   <translation>Krümmungskämme</translation>
  </message>
  <message>
   <source>Curvature itself, or its difference to the exact flank</source>
   <translation>Die Krümmung selbst, oder ihr Unterschied zur exakten Flanke</translation>
  </message>
  <message>
   <source>Curvature of the modelled flanks, as the paper's Fig. 11, or its difference to theory</source>
   <translation>Krümmung der modellierten Flanken wie in Bild 11 der Arbeit, oder ihr Unterschied zur Theorie</translation>
  </message>
  <message>
   <source>Curves along the tooth that guide the surface</source>
   <translation>Kurven entlang des Zahns, die die Fläche führen</translation>
  </message>
  <message>
   <source>Custom</source>
   <translation>Eigenes</translation>
  </message>
  <message>
   <source>Cut</source>
   <translation>Ausschneiden</translation>
  </message>
  <message>
   <source>Cut from the blank (slow)</source>
   <translation>Geschnitten (langsam)</translation>
  </message>
  <message>
   <source>Cut square to the {axis} axis</source>
   <translation>Schnitt rechtwinklig zur Achse {axis}</translation>
  </message>
  <message>
   <source>Cutter radius</source>
   <translation>Messerkopfradius</translation>
  </message>
  <message>
   <source>D is the drive flank, concave on the pinion and convex on the wheel; C is the coast flank. Each flank of the wheel is a spherical involute on a base cone of its own.</source>
   <translation>D ist die Zugflanke, am Ritzel konkav und am Rad konvex; C ist die Schubflanke. Jede Flanke des Rads ist eine Kugelevolvente auf einem eigenen Grundkegel.</translation>
  </message>
  <message>
   <source>Dark</source>
   <translation>Dunkel</translation>
  </message>
  <message>
   <source>Dark – bright</source>
   <translation>Dunkel – hell</translation>
  </message>
  <message>
   <source>Data sheet</source>
   <translation>Datenblatt</translation>
  </message>
  <message>
   <source>Data sheet or published values</source>
   <translation>Datenblatt oder veröffentlichte Werte</translation>
  </message>
  <message>
   <source>Decide &amp;later</source>
   <translation>&amp;Später entscheiden</translation>
  </message>
  <message>
   <source>Decimals</source>
   <translation>Nachkommastellen</translation>
  </message>
  <message>
   <source>Dedendum angle</source>
   <translation>Fußwinkel</translation>
  </message>
  <message>
   <source>Dedendum, heel</source>
   <translation>Fußhöhe, Ferse</translation>
  </message>
  <message>
   <source>Default spiral bevel pair</source>
   <translation>Übliches Spiralkegelradpaar</translation>
  </message>
  <message>
   <source>Default: {value}</source>
   <translation>Vorgabe: {value}</translation>
  </message>
  <message>
   <source>Degree</source>
   <translation>Grad</translation>
  </message>
  <message>
   <source>Degree of the surface through the point cloud.</source>
   <translation>Grad der Fläche durch die Punktwolke.</translation>
  </message>
  <message>
   <source>Degree of the surface, u × v</source>
   <translation>Grad der Fläche, u × v</translation>
  </message>
  <message>
   <source>Density</source>
   <translation>Dichte</translation>
  </message>
  <message>
   <source>Density of points</source>
   <translation>Punktdichte</translation>
  </message>
  <message>
   <source>Density of the material in {unit}</source>
   <translation>Dichte des Werkstoffs in {unit}</translation>
  </message>
  <message>
   <source>Depth</source>
   <translation>Zahnhöhe</translation>
  </message>
  <message>
   <source>Depth after ISO 23509</source>
   <translation>Zahnhöhe nach ISO 23509</translation>
  </message>
  <message>
   <source>Depth factor</source>
   <translation>Zahnhöhenfaktor</translation>
  </message>
  <message>
   <source>Depth system</source>
   <translation>Zahnhöhensystem</translation>
  </message>
  <message>
   <source>Depths</source>
   <translation>Zahnhöhen</translation>
  </message>
  <message>
   <source>Depths along the tooth</source>
   <translation>Zahnhöhen entlang des Zahns</translation>
  </message>
  <message>
   <source>Depths from the module</source>
   <translation>Zahnhöhen aus dem Modul</translation>
  </message>
  <message>
   <source>Derived values</source>
   <translation>Abgeleitete Werte</translation>
  </message>
  <message>
   <source>Derived values of both members</source>
   <translation>Abgeleitete Werte beider Räder</translation>
  </message>
  <message>
   <source>Design</source>
   <translation>Entwurf</translation>
  </message>
  <message>
   <source>Design in use</source>
   <translation>Entwurf in Gebrauch</translation>
  </message>
  <message>
   <source>Design, data sheets, comparison, maps, contact and equations as a PDF</source>
   <translation>Entwurf, Datenblätter, Vergleich, Karten, Kontakt und Gleichungen als PDF</translation>
  </message>
  <message>
   <source>Designs that were saved on this computer</source>
   <translation>Entwürfe, die auf diesem Rechner gespeichert wurden</translation>
  </message>
  <message>
   <source>Designs with unsaved work</source>
   <translation>Entwürfe mit ungesicherter Arbeit</translation>
  </message>
  <message>
   <source>Designs, backups and unsaved work stay. The old settings are kept as a .bak file.</source>
   <translation>Entwürfe, Sicherungen und ungesicherte Arbeit bleiben. Die alten Einstellungen bleiben als .bak-Datei.</translation>
  </message>
  <message>
   <source>Details</source>
   <translation>Einzelheiten</translation>
  </message>
  <message>
   <source>Details of the message</source>
   <translation>Einzelheiten der Meldung</translation>
  </message>
  <message>
   <source>Deutsch</source>
   <translation>Deutsch</translation>
  </message>
  <message>
   <source>Deviation</source>
   <translation>Abweichung</translation>
  </message>
  <message>
   <source>Deviation against positions, sections or points, poles, and seconds</source>
   <translation>Abweichung über Stellungen, Schnitten oder Punkten, Polen und Sekunden</translation>
  </message>
  <message>
   <source>Deviation along a series of points, as the paper's Fig. 12</source>
   <translation>Abweichung entlang einer Punktfolge, wie in Bild 12 der Arbeit</translation>
  </message>
  <message>
   <source>Deviation along points, histogram</source>
   <translation>Abweichung entlang von Punkten, Histogramm</translation>
  </message>
  <message>
   <source>Deviation as a bar at each point, both flanks drawn flat</source>
   <translation>Abweichung als Balken an jedem Punkt, beide Flanken flach gezeichnet</translation>
  </message>
  <message>
   <source>Deviation maps</source>
   <translation>Abweichungskarten</translation>
  </message>
  <message>
   <source>Deviation of a point</source>
   <translation>Abweichung eines Punkts</translation>
  </message>
  <message>
   <source>Deviation of the CAD surface from the exact flank in µm, normal to it, over both flanks on a grid of 49 × 49 points that includes the edges. The paper states means of {means} µm for its own gear, whose data it does not print.</source>
   <translation>Abweichung der CAD-Fläche von der exakten Flanke in µm, senkrecht zu ihr, über beide Flanken auf einem Gitter von 49 × 49 Punkten mit den Rändern. Die Veröffentlichung nennt Mittelwerte von {means} µm für ihr eigenes Rad, dessen Daten sie nicht druckt.</translation>
  </message>
  <message>
   <source>Deviation, absolute</source>
   <translation>Abweichung, Betrag</translation>
  </message>
  <message>
   <source>Deviation, {kind}</source>
   <translation>Abweichung, {kind}</translation>
  </message>
  <message>
   <source>Deviations are normal to the flank, plus is metal added. Errors are those of all teeth of a flank together: of the spiral angle from toe to heel, of the pressure angle from root to tip, crowning as the height of the middle above the ends, the pitch as an arc of the mean pitch circle.</source>
   <translation>Abweichungen stehen senkrecht auf der Flanke, plus bedeutet mehr Werkstoff. Die Fehler gelten für alle Zähne einer Flanke zusammen: der des Spiralwinkels von der Zehe zur Ferse, der des Eingriffswinkels vom Fuß zum Kopf, Balligkeit als Höhe der Mitte über den Enden, die Teilung als Bogen des mittleren Teilkreises.</translation>
  </message>
  <message>
   <source>Deviations of all methods and variants, as a table and along the flank</source>
   <translation>Abweichungen aller Methoden und Varianten, als Tabelle und entlang der Flanke</translation>
  </message>
  <message>
   <source>Deviations stay in µm and nm; the colour scale of the views has µin as well.</source>
   <translation>Abweichungen bleiben in µm und nm; die Farbskala der Ansichten hat auch µin.</translation>
  </message>
  <message>
   <source>Diameter of a solid shank behind the back face, 0 for none; it replaces the bore.</source>
   <translation>Durchmesser eines vollen Schafts hinter der Rückfläche, 0 für keinen; er ersetzt die Bohrung.</translation>
  </message>
  <message>
   <source>Diameter of the bore, 0 for none; leave empty to derive it from the pair.</source>
   <translation>Durchmesser der Bohrung, 0 für keine; leer: aus dem Paar abgeleitet.</translation>
  </message>
  <message>
   <source>Diameters</source>
   <translation>Durchmesser</translation>
  </message>
  <message>
   <source>Difference</source>
   <translation>Unterschied</translation>
  </message>
  <message>
   <source>Differences</source>
   <translation>Unterschiede</translation>
  </message>
  <message>
   <source>Differs from what is open in</source>
   <translation>Weicht vom Offenen ab in</translation>
  </message>
  <message>
   <source>Digits after the point of lengths in mm and angles; two more in inches</source>
   <translation>Nachkommastellen von Längen in mm und Winkeln; zwei mehr in Zoll</translation>
  </message>
  <message>
   <source>Dimensions of both members with the standard's names</source>
   <translation>Maße beider Räder mit den Namen der Norm</translation>
  </message>
  <message>
   <source>Direction</source>
   <translation>Richtung</translation>
  </message>
  <message>
   <source>Direction of the curvature combs; the layer list switches them on</source>
   <translation>Richtung der Krümmungskämme; die Ebenenliste schaltet sie ein</translation>
  </message>
  <message>
   <source>Direction of the lamps</source>
   <translation>Richtung der Lampen</translation>
  </message>
  <message>
   <source>Directions x, y and z of the gear</source>
   <translation>Richtungen x, y und z des Rads</translation>
  </message>
  <message>
   <source>Discard recovered</source>
   <translation>Wiederhergestelltes verwerfen</translation>
  </message>
  <message>
   <source>Dismiss</source>
   <translation>Ausblenden</translation>
  </message>
  <message>
   <source>Display</source>
   <translation>Darstellung</translation>
  </message>
  <message>
   <source>Display and work as for a new user; keys have a button of their own</source>
   <translation>Anzeige und Arbeit wie für neue Benutzer; Tasten haben einen eigenen Knopf</translation>
  </message>
  <message>
   <source>Distance</source>
   <translation>Abstand</translation>
  </message>
  <message>
   <source>Distance between the axes of a hypoid pair; 0 is a bevel pair. Positive makes the pinion's spiral angle the larger one. With an offset the outer module and the face width are the wheel's.</source>
   <translation>Achsabstand eines Hypoidpaars; 0 ist ein Kegelradpaar. Positiv vergrößert den Spiralwinkel des Ritzels. Mit Achsversatz gelten Außenmodul und Zahnbreite für das Rad.</translation>
  </message>
  <message>
   <source>Do again what was taken back</source>
   <translation>Zurückgenommenes wiederholen</translation>
  </message>
  <message>
   <source>Does not hold for this pair, which has an offset or a depth after ISO 23509.</source>
   <translation>Gilt nicht für dieses Paar, das einen Achsversatz oder eine Zahnhöhe nach ISO 23509 hat.</translation>
  </message>
  <message>
   <source>Does not hold for this pair, which has no offset and depths from the module.</source>
   <translation>Gilt nicht für dieses Paar, das keinen Achsversatz und Zahnhöhen aus dem Modul hat.</translation>
  </message>
  <message>
   <source>Does not hold for this pair, which has no offset.</source>
   <translation>Gilt nicht für dieses Paar, das keinen Achsversatz hat.</translation>
  </message>
  <message>
   <source>Does not hold for this pair, whose axes have an offset.</source>
   <translation>Gilt nicht für dieses Paar, dessen Achsen versetzt sind.</translation>
  </message>
  <message>
   <source>Done again: {step}</source>
   <translation>Wiederholt: {step}</translation>
  </message>
  <message>
   <source>Drag the card to where it hides nothing</source>
   <translation>Die Karte dorthin ziehen, wo sie nichts verdeckt</translation>
  </message>
  <message>
   <source>Drag turns, the wheel zooms, a double click centres. Point at a flank to read its deviation there.</source>
   <translation>Ziehen dreht, das Rad zoomt, ein Doppelklick zentriert. Auf eine Flanke zeigen liest dort die Abweichung ab.</translation>
  </message>
  <message>
   <source>Draw deviations so many times as large, along the normal</source>
   <translation>Abweichungen so vielfach längs der Normalen zeichnen</translation>
  </message>
  <message>
   <source>Draw the CAD flanks with their deviation so many times as large, along the normal</source>
   <translation>Die CAD-Flanken mit so vielfacher Abweichung längs der Normalen zeichnen</translation>
  </message>
  <message>
   <source>Draw the edges of the faces</source>
   <translation>Die Kanten der Flächen zeichnen</translation>
  </message>
  <message>
   <source>Drawing by software failed too; install or update Mesa (libgl1-mesa-dri) or the driver.</source>
   <translation>Auch das Zeichnen durch Software misslang; Mesa (libgl1-mesa-dri) oder den Treiber installieren oder erneuern.</translation>
  </message>
  <message>
   <source>Drive</source>
   <translation>Zug</translation>
  </message>
  <message>
   <source>Duplex</source>
   <translation>Duplex</translation>
  </message>
  <message>
   <source>E  offset</source>
   <translation>E  Versatz</translation>
  </message>
  <message>
   <source>Each point P of the pinion, taken to the wheel, needs a turn q to touch. The smallest is the transmission error; what is left of the others is the gap g. Contact is where g is less than the marking compound's thickness.</source>
   <translation>Jeder Punkt P des Ritzels braucht, zum Rad gebracht, eine Drehung q bis zur Berührung. Die kleinste ist die Drehwegabweichung; was von den anderen bleibt, ist der Spalt g. Berührung ist, wo g kleiner als die Dicke der Tuschierpaste ist.</translation>
  </message>
  <message>
   <source>Each save leaves a copy. Going back changes no file until you save, and can be undone.</source>
   <translation>Jedes Speichern legt eine Kopie an. Zurückkehren ändert keine Datei, bis Sie speichern, und lässt sich rückgängig machen.</translation>
  </message>
  <message>
   <source>Ease-off</source>
   <translation>Ease-off</translation>
  </message>
  <message>
   <source>Ease-off over the pinion's flanks; white throughout where the flanks are exactly conjugate.</source>
   <translation>Ease-off über den Flanken des Ritzels; durchweg weiß, wo die Flanken genau konjugiert sind.</translation>
  </message>
  <message>
   <source>Edges</source>
   <translation>Kanten</translation>
  </message>
  <message>
   <source>Effort</source>
   <translation>Aufwand</translation>
  </message>
  <message>
   <source>Empty the panel; the log file stays</source>
   <translation>Die Tafel leeren; die Protokolldatei bleibt</translation>
  </message>
  <message>
   <source>Enclosed</source>
   <translation>Umschlossen</translation>
  </message>
  <message>
   <source>End chamfer</source>
   <translation>Endfase</translation>
  </message>
  <message>
   <source>End of the scale</source>
   <translation>Ende der Skala</translation>
  </message>
  <message>
   <source>End the CAD process and start a new one</source>
   <translation>Den CAD-Prozess beenden und neu starten</translation>
  </message>
  <message>
   <source>End the measurement</source>
   <translation>Messung beenden</translation>
  </message>
  <message>
   <source>English</source>
   <translation>English</translation>
  </message>
  <message>
   <source>Enter or a click carries out</source>
   <translation>Enter oder ein Klick führt aus</translation>
  </message>
  <message>
   <source>Equations</source>
   <translation>Gleichungen</translation>
  </message>
  <message>
   <source>Error</source>
   <translation>Fehler</translation>
  </message>
  <message>
   <source>Errors</source>
   <translation>Fehler</translation>
  </message>
  <message>
   <source>Errors [µm]</source>
   <translation>Fehler [µm]</translation>
  </message>
  <message>
   <source>Errors and statistics of the measured points</source>
   <translation>Fehler und Statistik der Messpunkte</translation>
  </message>
  <message>
   <source>Esc</source>
   <translation>Esc</translation>
  </message>
  <message>
   <source>Even in the distance and in the polar angle; δ₀ is the flank's lower edge, on the root cone or the base cone. With an offset the pinion's flank begins at the start of contact.</source>
   <translation>Gleichmäßig im Abstand und im Polarwinkel; δ₀ ist der untere Rand der Flanke, am Fuß- oder am Grundkegel. Mit Achsversatz beginnt die Flanke des Ritzels am Beginn der Berührung.</translation>
  </message>
  <message>
   <source>Evenly divided; by arc length or denser at the ends on request.</source>
   <translation>Gleichmäßig geteilt; auf Wunsch nach Bogenlänge oder an den Enden dichter.</translation>
  </message>
  <message>
   <source>Every field of the design with symbol, value and unit</source>
   <translation>Jedes Feld des Entwurfs mit Zeichen, Wert und Einheit</translation>
  </message>
  <message>
   <source>Every file was read back after it was written, and held against the exact geometry.</source>
   <translation>Jede Datei wurde nach dem Schreiben zurückgelesen und mit der exakten Geometrie verglichen.</translation>
  </message>
  <message>
   <source>Every formula, what the paper prints, and this design's numbers</source>
   <translation>Jede Formel, was die Arbeit druckt, und die Zahlen dieses Entwurfs</translation>
  </message>
  <message>
   <source>Every method built with more and more positions, sections or points, and nothing else refined.</source>
   <translation>Jede Methode mit immer mehr Lagen, Schnitten oder Punkten gebaut; sonst wurde nichts verfeinert.</translation>
  </message>
  <message>
   <source>Every value of the pair; a row explains itself</source>
   <translation>Jeder Wert des Paars; eine Zeile erklärt sich selbst</translation>
  </message>
  <message>
   <source>Every value of the pair; an offset makes it hypoid. Change one and everything follows, or its problem is told at its field. Shift+F1 explains a field, Ctrl+F1 shows its equation.</source>
   <translation>Jeder Wert des Paars; ein Achsversatz macht es hypoid. Eine Änderung zieht alles nach, oder ihr Problem steht an ihrem Feld. Umschalt+F1 erklärt ein Feld, Strg+F1 zeigt seine Gleichung.</translation>
  </message>
  <message>
   <source>Everything</source>
   <translation>Alles</translation>
  </message>
  <message>
   <source>Everything else works: parameters, comparison, charts, data sheets and exports.</source>
   <translation>Alles andere geht: Parameter, Vergleich, Diagramme, Datenblätter und Exporte.</translation>
  </message>
  <message>
   <source>Exaggerate</source>
   <translation>Überhöhung</translation>
  </message>
  <message>
   <source>Expand the analysis</source>
   <translation>Auswertung vergrößern</translation>
  </message>
  <message>
   <source>Explain the parameter with the cursor, or what is clicked</source>
   <translation>Den Parameter mit dem Cursor erklären, oder was angeklickt wird</translation>
  </message>
  <message>
   <source>Export</source>
   <translation>Export</translation>
  </message>
  <message>
   <source>Exporting {label}</source>
   <translation>{label} wird exportiert</translation>
  </message>
  <message>
   <source>Exports</source>
   <translation>Exporte</translation>
  </message>
  <message>
   <source>Face and root cone angles</source>
   <translation>Kopf- und Fußkegelwinkel</translation>
  </message>
  <message>
   <source>Face and root cone of the pinion</source>
   <translation>Kopf- und Fußkegel des Ritzels</translation>
  </message>
  <message>
   <source>Face angle</source>
   <translation>Kopfkegelwinkel</translation>
  </message>
  <message>
   <source>Face apex beyond crossing point</source>
   <translation>Kopfkegelspitze über dem Achsschnittpunkt</translation>
  </message>
  <message>
   <source>Face cone at constant clearance</source>
   <translation>Kopfkegel bei gleichbleibendem Kopfspiel</translation>
  </message>
  <message>
   <source>Face farthest from theory</source>
   <translation>Fläche mit der größten Abweichung</translation>
  </message>
  <message>
   <source>Face width</source>
   <translation>Zahnbreite</translation>
  </message>
  <message>
   <source>Face width along the pitch cone; leave empty to take the factor.</source>
   <translation>Zahnbreite entlang des Teilkegels; leer: aus dem Faktor.</translation>
  </message>
  <message>
   <source>Face width factor</source>
   <translation>Zahnbreitenfaktor</translation>
  </message>
  <message>
   <source>Face width from mean point to heel</source>
   <translation>Breite Mittelpunkt bis Ferse</translation>
  </message>
  <message>
   <source>Face width from mean point to toe</source>
   <translation>Breite Mittelpunkt bis Zehe</translation>
  </message>
  <message>
   <source>Face width over outer cone distance; a face width that is given wins over it.</source>
   <translation>Zahnbreite durch äußere Teilkegellänge; eine angegebene Zahnbreite hat Vorrang.</translation>
  </message>
  <message>
   <source>Faces</source>
   <translation>Flächen</translation>
  </message>
  <message>
   <source>Faces joined into one shell, or tooth spaces cut from the blank by Booleans</source>
   <translation>Flächen zu einer Hülle verbunden, oder Zahnlücken durch Boolesche Operationen geschnitten</translation>
  </message>
  <message>
   <source>Field</source>
   <translation>Feld</translation>
  </message>
  <message>
   <source>Fields that differ from their defaults; the context menu resets the group</source>
   <translation>Felder, die von der Vorgabe abweichen; das Kontextmenü setzt die Gruppe zurück</translation>
  </message>
  <message>
   <source>Fields with a problem</source>
   <translation>Felder mit einem Problem</translation>
  </message>
  <message>
   <source>File</source>
   <translation>Datei</translation>
  </message>
  <message>
   <source>File changed</source>
   <translation>Datei geändert</translation>
  </message>
  <message>
   <source>Files</source>
   <translation>Dateien</translation>
  </message>
  <message>
   <source>Files and help</source>
   <translation>Dateien und Hilfe</translation>
  </message>
  <message>
   <source>Fillet factor</source>
   <translation>Fußrundungsfaktor</translation>
  </message>
  <message>
   <source>Fillet radius</source>
   <translation>Fußrundungsradius</translation>
  </message>
  <message>
   <source>Fillet radius on the heel sphere over mean normal module.</source>
   <translation>Fußrundungsradius auf der Fersenkugel durch mittleren Normalmodul.</translation>
  </message>
  <message>
   <source>Fillet radius, heel</source>
   <translation>Fußradius, Ferse</translation>
  </message>
  <message>
   <source>Film</source>
   <translation>Film</translation>
  </message>
  <message>
   <source>Find a command or a key</source>
   <translation>Befehl oder Taste finden</translation>
  </message>
  <message>
   <source>Find a parameter</source>
   <translation>Parameter finden</translation>
  </message>
  <message>
   <source>Find an equation</source>
   <translation>Gleichung finden</translation>
  </message>
  <message>
   <source>Find any command or parameter by a few letters</source>
   <translation>Jeden Befehl oder Parameter mit wenigen Buchstaben finden</translation>
  </message>
  <message>
   <source>Find in guide and glossary</source>
   <translation>In Anleitung und Glossar finden</translation>
  </message>
  <message>
   <source>Fine</source>
   <translation>Fein</translation>
  </message>
  <message>
   <source>Fine instrument pair</source>
   <translation>Feines Instrumentenpaar</translation>
  </message>
  <message>
   <source>Fit all</source>
   <translation>Alles einpassen</translation>
  </message>
  <message>
   <source>Flank</source>
   <translation>Flanke</translation>
  </message>
  <message>
   <source>Flank colours</source>
   <translation>Farben der Flanken</translation>
  </message>
  <message>
   <source>Flanks are drawn with their deviation {factor}</source>
   <translation>Flanken sind mit Abweichung {factor} gezeichnet</translation>
  </message>
  <message>
   <source>Flanks coloured by deviation</source>
   <translation>Abweichung in Farben</translation>
  </message>
  <message>
   <source>Flanks of one tooth</source>
   <translation>Flanken eines Zahns</translation>
  </message>
  <message>
   <source>Flanks of the pinion</source>
   <translation>Flanken des Ritzels</translation>
  </message>
  <message>
   <source>Flat: the flanks are conjugate</source>
   <translation>Eben: die Flanken sind konjugiert</translation>
  </message>
  <message>
   <source>Fold all groups</source>
   <translation>Alle Gruppen zuklappen</translation>
  </message>
  <message>
   <source>Fold or unfold this group</source>
   <translation>Diese Gruppe auf- oder zuklappen</translation>
  </message>
  <message>
   <source>Folder</source>
   <translation>Ordner</translation>
  </message>
  <message>
   <source>Folder for the exported files</source>
   <translation>Ordner für die exportierten Dateien</translation>
  </message>
  <message>
   <source>Folder not found</source>
   <translation>Ordner nicht gefunden</translation>
  </message>
  <message>
   <source>For the Archimedean spiral with β₀ at the toe; for other curves the same difference θ(R) − θ(R − B).</source>
   <translation>Für die archimedische Spirale mit β₀ an der Zehe; für andere Kurven dieselbe Differenz θ(R) − θ(R − B).</translation>
  </message>
  <message>
   <source>Forget layout, lists and preferences; designs stay</source>
   <translation>Anordnung, Listen und Einstellungen vergessen; Entwürfe bleiben</translation>
  </message>
  <message>
   <source>Forget the edits that were not saved</source>
   <translation>Die ungesicherten Änderungen vergessen</translation>
  </message>
  <message>
   <source>Forget the layout, the list of recent files and all preferences?</source>
   <translation>Anordnung, Liste der letzten Dateien und alle Einstellungen vergessen?</translation>
  </message>
  <message>
   <source>Forget the unsaved edits of “{name}” for good?</source>
   <translation>Ungesicherte Änderungen an „{name}“ endgültig vergessen?</translation>
  </message>
  <message>
   <source>Formula</source>
   <translation>Formel</translation>
  </message>
  <message>
   <source>Frames</source>
   <translation>Bilder/s</translation>
  </message>
  <message>
   <source>Frames in a second</source>
   <translation>Bilder je Sekunde</translation>
  </message>
  <message>
   <source>From [{unit}]</source>
   <translation>Von [{unit}]</translation>
  </message>
  <message>
   <source>From the apex</source>
   <translation>Von der Spitze</translation>
  </message>
  <message>
   <source>From the apex to the back face.</source>
   <translation>Von der Spitze bis zur Rückfläche.</translation>
  </message>
  <message>
   <source>From the back face toward the apex; the toe limits it.</source>
   <translation>Von der Rückfläche zur Spitze hin; die Zehe begrenzt sie.</translation>
  </message>
  <message>
   <source>From the heel</source>
   <translation>Von der Ferse</translation>
  </message>
  <message>
   <source>From the toe to the heel.</source>
   <translation>Von der Zehe zur Ferse.</translation>
  </message>
  <message>
   <source>From the wheel's pitch cone to its face cone; leave empty to take the taper's.</source>
   <translation>Vom Teilkegel des Rads zu seinem Kopfkegel; leer: aus der Verjüngung.</translation>
  </message>
  <message>
   <source>From the wheel's root cone to its pitch cone; leave empty to take the taper's.</source>
   <translation>Vom Fußkegel des Rads zu seinem Teilkegel; leer: aus der Verjüngung.</translation>
  </message>
  <message>
   <source>Front</source>
   <translation>Vorn</translation>
  </message>
  <message>
   <source>Front crown to apex</source>
   <translation>Vordere Kopfkante zur Spitze</translation>
  </message>
  <message>
   <source>Front crown to crossing point</source>
   <translation>Vordere Kopfkante zum Kreuzungspunkt</translation>
  </message>
  <message>
   <source>G  wheel axial</source>
   <translation>G  Rad axial</translation>
  </message>
  <message>
   <source>G&amp;lossary</source>
   <translation>Gl&amp;ossar</translation>
  </message>
  <message>
   <source>GLB unit</source>
   <translation>GLB-Einheit</translation>
  </message>
  <message>
   <source>GLB up</source>
   <translation>GLB-Hochachse</translation>
  </message>
  <message>
   <source>Gap</source>
   <translation>Spalt</translation>
  </message>
  <message>
   <source>Gap between the flanks beyond that at the mean point, with contours</source>
   <translation>Abstand der Flanken über den im Mittelpunkt hinaus, mit Höhenlinien</translation>
  </message>
  <message>
   <source>Gaussian</source>
   <translation>Gauß</translation>
  </message>
  <message>
   <source>Gaussian curvature</source>
   <translation>Gaußsche Krümmung</translation>
  </message>
  <message>
   <source>Gaussian curvature of the surfaces and of theory</source>
   <translation>Gaußsche Krümmung der Flächen und der Theorie</translation>
  </message>
  <message>
   <source>Gear designs (*.gear.toml);;All files (*)</source>
   <translation>Radentwürfe (*.gear.toml);;Alle Dateien (*)</translation>
  </message>
  <message>
   <source>Gear ratio</source>
   <translation>Übersetzung</translation>
  </message>
  <message>
   <source>GearStudio ended unexpectedly. Of these designs it kept edits that were not saved.</source>
   <translation>GearStudio endete unerwartet. Von diesen Entwürfen hat es ungesicherte Änderungen bewahrt.</translation>
  </message>
  <message>
   <source>Generating line</source>
   <translation>Erzeugende</translation>
  </message>
  <message>
   <source>Generation</source>
   <translation>Erzeugung</translation>
  </message>
  <message>
   <source>Geometry data sheet</source>
   <translation>Geometriedatenblatt</translation>
  </message>
  <message>
   <source>Geometry of both members; every value explains itself</source>
   <translation>Geometrie beider Räder; jeder Wert erklärt sich</translation>
  </message>
  <message>
   <source>Give every command its usual keys</source>
   <translation>Jedem Befehl die üblichen Tasten geben</translation>
  </message>
  <message>
   <source>Give every parameter its default back; can be undone</source>
   <translation>Jedem Parameter die Vorgabe zurückgeben; umkehrbar</translation>
  </message>
  <message>
   <source>Give the analysis the room of the 3D views</source>
   <translation>Der Auswertung den Platz der 3D-Ansichten geben</translation>
  </message>
  <message>
   <source>Give the command its usual keys</source>
   <translation>Dem Befehl die üblichen Tasten geben</translation>
  </message>
  <message>
   <source>Give the command these keys</source>
   <translation>Dem Befehl diese Tasten geben</translation>
  </message>
  <message>
   <source>Give the field with the cursor its default back</source>
   <translation>Dem Feld mit dem Cursor die Vorgabe zurückgeben</translation>
  </message>
  <message>
   <source>Give the film up; no file is left</source>
   <translation>Den Film aufgeben; keine Datei bleibt</translation>
  </message>
  <message>
   <source>Glossary</source>
   <translation>Glossar</translation>
  </message>
  <message>
   <source>Go back to one of the last saves</source>
   <translation>Zu einem der letzten Stände zurückkehren</translation>
  </message>
  <message>
   <source>Go back to the save of {date}</source>
   <translation>Zum Stand vom {date} zurückkehren</translation>
  </message>
  <message>
   <source>Go on</source>
   <translation>Fortfahren</translation>
  </message>
  <message>
   <source>Go on with the edits that were not saved</source>
   <translation>Mit den ungesicherten Änderungen fortfahren</translation>
  </message>
  <message>
   <source>Go to a heading</source>
   <translation>Zu einer Überschrift gehen</translation>
  </message>
  <message>
   <source>Go to the parameter in the window</source>
   <translation>Zum Parameter im Fenster gehen</translation>
  </message>
  <message>
   <source>Grey</source>
   <translation>Grau</translation>
  </message>
  <message>
   <source>Greys</source>
   <translation>Grautöne</translation>
  </message>
  <message>
   <source>Ground</source>
   <translation>Grund</translation>
  </message>
  <message>
   <source>Group</source>
   <translation>Gruppe</translation>
  </message>
  <message>
   <source>Guide</source>
   <translation>Anleitung</translation>
  </message>
  <message>
   <source>Guide curve along the tip</source>
   <translation>Führungskurve am Kopf</translation>
  </message>
  <message>
   <source>Guide curves</source>
   <translation>Führungskurven</translation>
  </message>
  <message>
   <source>Guide curves follow the flank on tip and root.</source>
   <translation>Führungskurven folgen der Flanke an Kopf und Fuß.</translation>
  </message>
  <message>
   <source>Guide or glossary</source>
   <translation>Anleitung oder Glossar</translation>
  </message>
  <message>
   <source>Half the tooth's thickness</source>
   <translation>Halbe Zahndicke</translation>
  </message>
  <message>
   <source>Half the tooth, azimuth on the pitch cone</source>
   <translation>Halber Zahn, Azimut auf dem Teilkegel</translation>
  </message>
  <message>
   <source>Hand of spiral</source>
   <translation>Spiralrichtung</translation>
  </message>
  <message>
   <source>Hand of spiral of the pinion; the wheel has the other.</source>
   <translation>Spiralrichtung des Ritzels; das Rad hat die andere.</translation>
  </message>
  <message>
   <source>Hand of the pinion</source>
   <translation>Spiralrichtung des Ritzels</translation>
  </message>
  <message>
   <source>Headings</source>
   <translation>Überschriften</translation>
  </message>
  <message>
   <source>Heel and toe profiles, sections and positions used</source>
   <translation>Profile an Ferse und Zehe, benutzte Schnitte und Stellungen</translation>
  </message>
  <message>
   <source>Highest deviation</source>
   <translation>Höchste Abweichung</translation>
  </message>
  <message>
   <source>Histogram</source>
   <translation>Histogramm</translation>
  </message>
  <message>
   <source>How a whole gear is put together</source>
   <translation>Wie ein ganzes Rad zusammengesetzt wird</translation>
  </message>
  <message>
   <source>How far it lies beyond the crossing point; t_zm is the mean point's distance along the axis.</source>
   <translation>Wie weit sie über dem Kreuzungspunkt liegt; t_zm ist der Abstand des Mittelpunkts entlang der Achse.</translation>
  </message>
  <message>
   <source>How far the plane has rolled. It starts at 0 where the root lies below the base cone.</source>
   <translation>Wie weit die Ebene gerollt ist. Sie beginnt bei 0, wo der Fuß unter dem Grundkegel liegt.</translation>
  </message>
  <message>
   <source>How far triangles may lie from the surfaces; left empty, 1e-4 of the outer cone distance</source>
   <translation>Wie weit Dreiecke von den Flächen liegen dürfen; leer: 1e-4 der äußeren Teilkegellänge</translation>
  </message>
  <message>
   <source>How many colours</source>
   <translation>Wie viele Farben</translation>
  </message>
  <message>
   <source>How many points are taken of a CAD model's flanks</source>
   <translation>Wie viele Punkte von den Flanken eines CAD-Modells genommen werden</translation>
  </message>
  <message>
   <source>How much of the layer one sees; as made, some layers are glass</source>
   <translation>Wie viel man von der Ebene sieht; manche sind von sich aus gläsern</translation>
  </message>
  <message>
   <source>How often which deviation occurs</source>
   <translation>Wie oft welche Abweichung vorkommt</translation>
  </message>
  <message>
   <source>How the value came about</source>
   <translation>Wie der Wert zustande kam</translation>
  </message>
  <message>
   <source>How they are written</source>
   <translation>Wie sie geschrieben werden</translation>
  </message>
  <message>
   <source>How to use the studio</source>
   <translation>So wird das Studio benutzt</translation>
  </message>
  <message>
   <source>Hub diameter</source>
   <translation>Nabendurchmesser</translation>
  </message>
  <message>
   <source>Hub length</source>
   <translation>Nabenlänge</translation>
  </message>
  <message>
   <source>Hypoid offset</source>
   <translation>Achsversatz</translation>
  </message>
  <message>
   <source>Hypoid, all-wheel drive at 80°</source>
   <translation>Hypoid, Allradantrieb bei 80°</translation>
  </message>
  <message>
   <source>Hypoid, heavy truck</source>
   <translation>Hypoid, schwerer Lkw</translation>
  </message>
  <message>
   <source>Hypoid, negative offset</source>
   <translation>Hypoid, negativer Achsversatz</translation>
  </message>
  <message>
   <source>Hypoid, passenger car</source>
   <translation>Hypoid, Pkw</translation>
  </message>
  <message>
   <source>Hypoid, pick-up</source>
   <translation>Hypoid, Pick-up</translation>
  </message>
  <message>
   <source>IGES bodies</source>
   <translation>IGES-Körper</translation>
  </message>
  <message>
   <source>IGES unit</source>
   <translation>IGES-Einheit</translation>
  </message>
  <message>
   <source>ISO 23509</source>
   <translation>ISO 23509</translation>
  </message>
  <message>
   <source>ISO 23509:2016, sample F.2, spiral bevel pair 14/39</source>
   <translation>ISO 23509:2016, Beispiel F.2, Spiralkegelradpaar 14/39</translation>
  </message>
  <message>
   <source>In the chosen material</source>
   <translation>Im gewählten Werkstoff</translation>
  </message>
  <message>
   <source>In the design file: {key}</source>
   <translation>In der Entwurfsdatei: {key}</translation>
  </message>
  <message>
   <source>In the glossary: {term}</source>
   <translation>Im Glossar: {term}</translation>
  </message>
  <message>
   <source>Inches</source>
   <translation>Zoll</translation>
  </message>
  <message>
   <source>Inertia x</source>
   <translation>Trägheit x</translation>
  </message>
  <message>
   <source>Inertia z</source>
   <translation>Trägheit z</translation>
  </message>
  <message>
   <source>Inner addendum</source>
   <translation>Innere Kopfhöhe</translation>
  </message>
  <message>
   <source>Inner clearance</source>
   <translation>Inneres Kopfspiel</translation>
  </message>
  <message>
   <source>Inner cone distance</source>
   <translation>Kegellänge, innen</translation>
  </message>
  <message>
   <source>Inner dedendum</source>
   <translation>Innere Fußhöhe</translation>
  </message>
  <message>
   <source>Inner pitch diameter</source>
   <translation>Innerer Teilkreisdurchmesser</translation>
  </message>
  <message>
   <source>Inner root diameter</source>
   <translation>Innerer Fußkreisdurchmesser</translation>
  </message>
  <message>
   <source>Inner spiral angle</source>
   <translation>Innerer Spiralwinkel</translation>
  </message>
  <message>
   <source>Inner tip diameter</source>
   <translation>Innerer Kopfkreisdurchmesser</translation>
  </message>
  <message>
   <source>Inner whole depth</source>
   <translation>Innere Zahnhöhe</translation>
  </message>
  <message>
   <source>Isometric</source>
   <translation>Isometrisch</translation>
  </message>
  <message>
   <source>It could not be put aside.</source>
   <translation>Sie konnte nicht beiseitegelegt werden.</translation>
  </message>
  <message>
   <source>It is kept as {file}.</source>
   <translation>Sie liegt als {file} bereit.</translation>
  </message>
  <message>
   <source>It needs a pair with an offset.</source>
   <translation>Braucht ein Paar mit Achsversatz.</translation>
  </message>
  <message>
   <source>It needs “{choice}” as {field}.</source>
   <translation>Braucht „{choice}“ bei: {field}.</translation>
  </message>
  <message>
   <source>Its version can be taken, and Undo brings this one back; or keep this one.</source>
   <translation>Ihr Stand kann übernommen werden, Rückgängig bringt diesen zurück; oder diesen behalten.</translation>
  </message>
  <message>
   <source>KHK gear technical reference, Gleason spiral bevel pair 20/40</source>
   <translation>KHK-Zahnradtechnik, Gleason-Spiralkegelradpaar 20/40</translation>
  </message>
  <message>
   <source>Keep a record of the check beside each file</source>
   <translation>Neben jeder Datei einen Prüfbericht ablegen</translation>
  </message>
  <message>
   <source>Keep everything; File ▸ Recover unsaved work, or the next start, asks again</source>
   <translation>Alles behalten; Datei ▸ Ungesicherte Arbeit wiederherstellen oder der nächste Start fragt wieder</translation>
  </message>
  <message>
   <source>Key in the design file</source>
   <translation>Schlüssel in der Entwurfsdatei</translation>
  </message>
  <message>
   <source>Key in {table}</source>
   <translation>Schlüssel in {table}</translation>
  </message>
  <message>
   <source>Keys</source>
   <translation>Tasten</translation>
  </message>
  <message>
   <source>Keys of all commands</source>
   <translation>Tasten aller Befehle</translation>
  </message>
  <message>
   <source>Lamps</source>
   <translation>Lampen</translation>
  </message>
  <message>
   <source>Language</source>
   <translation>Sprache</translation>
  </message>
  <message>
   <source>Language of the report</source>
   <translation>Sprache des Berichts</translation>
  </message>
  <message>
   <source>Largest</source>
   <translation>Größte</translation>
  </message>
  <message>
   <source>Largest [µm]</source>
   <translation>Größte [µm]</translation>
  </message>
  <message>
   <source>Largest angle between neighbouring chords; left empty, the distance alone decides</source>
   <translation>Größter Winkel zwischen benachbarten Sehnen; leer: nur der Abstand entscheidet</translation>
  </message>
  <message>
   <source>Largest between neighbouring faces</source>
   <translation>Größter zwischen benachbarten Flächen</translation>
  </message>
  <message>
   <source>Largest deviation against poles and seconds of each method</source>
   <translation>Größte Abweichung jeder Methode über Polen und Sekunden</translation>
  </message>
  <message>
   <source>Largest deviation from the exact flank, over both flanks</source>
   <translation>Größte Abweichung von der exakten Flanke, über beide Flanken</translation>
  </message>
  <message>
   <source>Largest deviation over both flanks</source>
   <translation>Größte Abweichung über beide Flanken</translation>
  </message>
  <message>
   <source>Largest deviation without its sign</source>
   <translation>Größte Abweichung dem Betrag nach</translation>
  </message>
  <message>
   <source>Largest principal</source>
   <translation>Größte</translation>
  </message>
  <message>
   <source>Layers</source>
   <translation>Ebenen</translation>
  </message>
  <message>
   <source>Leave it empty to use the derived value shown in grey.</source>
   <translation>Leer lassen für den grau gezeigten abgeleiteten Wert.</translation>
  </message>
  <message>
   <source>Leave out what both designs have in common</source>
   <translation>Weglassen, was beide Entwürfe gemeinsam haben</translation>
  </message>
  <message>
   <source>Leave the tour; Help ▸ Tour starts it again</source>
   <translation>Rundgang verlassen; Hilfe ▸ Rundgang beginnt ihn wieder</translation>
  </message>
  <message>
   <source>Left</source>
   <translation>Links</translation>
  </message>
  <message>
   <source>Left hand</source>
   <translation>Linkssteigend</translation>
  </message>
  <message>
   <source>Length</source>
   <translation>Länge</translation>
  </message>
  <message>
   <source>Length of the combs; teeth longer than three typical ones are cut off</source>
   <translation>Länge der Kämme; Zähne über drei übliche hinaus werden gekappt</translation>
  </message>
  <message>
   <source>Length of the film</source>
   <translation>Länge des Films</translation>
  </message>
  <message>
   <source>Length of the shank behind the back face, 0 for none.</source>
   <translation>Länge des Schafts hinter der Rückfläche, 0 für keinen.</translation>
  </message>
  <message>
   <source>Lengths in</source>
   <translation>Längen in</translation>
  </message>
  <message>
   <source>Lengthwise</source>
   <translation>Längs</translation>
  </message>
  <message>
   <source>Lengthwise crown</source>
   <translation>Breitenballigkeit</translation>
  </message>
  <message>
   <source>Lengthwise crowning</source>
   <translation>Breitenballigkeit</translation>
  </message>
  <message>
   <source>Lengthwise curve</source>
   <translation>Flankenlinie</translation>
  </message>
  <message>
   <source>Less theory</source>
   <translation>Minus Theorie</translation>
  </message>
  <message>
   <source>Less theory, in %</source>
   <translation>Minus Theorie, in %</translation>
  </message>
  <message>
   <source>Let the range follow the values shown</source>
   <translation>Der Bereich folgt den gezeigten Werten</translation>
  </message>
  <message>
   <source>Letters of a command, or a key such as Ctrl+S</source>
   <translation>Buchstaben eines Befehls, oder eine Taste wie Strg+S</translation>
  </message>
  <message>
   <source>Level</source>
   <translation>Stufe</translation>
  </message>
  <message>
   <source>Light</source>
   <translation>Hell</translation>
  </message>
  <message>
   <source>Limit [µm]</source>
   <translation>Grenze [µm]</translation>
  </message>
  <message>
   <source>Limit pressure angle</source>
   <translation>Grenzeingriffswinkel</translation>
  </message>
  <message>
   <source>Limit pressure angle factor</source>
   <translation>Faktor des Grenzwinkels</translation>
  </message>
  <message>
   <source>Limit radius</source>
   <translation>Grenzradius</translation>
  </message>
  <message>
   <source>Linear</source>
   <translation>Linear</translation>
  </message>
  <message>
   <source>Lines of equal value at the marks of the colour scale</source>
   <translation>Linien gleichen Werts an den Marken der Farbskala</translation>
  </message>
  <message>
   <source>List and change the keys of all commands</source>
   <translation>Die Tasten aller Befehle zeigen und ändern</translation>
  </message>
  <message>
   <source>Log</source>
   <translation>Protokoll</translation>
  </message>
  <message>
   <source>Log scale</source>
   <translation>Logarithmisch</translation>
  </message>
  <message>
   <source>Logarithmic pair</source>
   <translation>Logarithmisches Paar</translation>
  </message>
  <message>
   <source>Logarithmic spiral</source>
   <translation>Logarithmische Spirale</translation>
  </message>
  <message>
   <source>Longest: {length}; up is metal added</source>
   <translation>Längster: {length}; oben ist Aufmaß</translation>
  </message>
  <message>
   <source>Look for edits that a window which ended unexpectedly had not saved</source>
   <translation>Nach ungesicherten Änderungen eines unerwartet beendeten Fensters suchen</translation>
  </message>
  <message>
   <source>Lower end of the scale</source>
   <translation>Unteres Ende der Skala</translation>
  </message>
  <message>
   <source>Lowest deviation</source>
   <translation>Niedrigste Abweichung</translation>
  </message>
  <message>
   <source>Lowest … highest</source>
   <translation>Von … bis</translation>
  </message>
  <message>
   <source>Made</source>
   <translation>Erstellt</translation>
  </message>
  <message>
   <source>Map</source>
   <translation>Karte</translation>
  </message>
  <message>
   <source>Maps and charts of</source>
   <translation>Karten und Diagramme von</translation>
  </message>
  <message>
   <source>Maps show</source>
   <translation>Karten zeigen</translation>
  </message>
  <message>
   <source>Margins</source>
   <translation>Reserven</translation>
  </message>
  <message>
   <source>Mass</source>
   <translation>Masse</translation>
  </message>
  <message>
   <source>Material</source>
   <translation>Werkstoff</translation>
  </message>
  <message>
   <source>Material that the mass is computed with</source>
   <translation>Werkstoff, mit dem die Masse berechnet wird</translation>
  </message>
  <message>
   <source>Max</source>
   <translation>Max</translation>
  </message>
  <message>
   <source>Mean</source>
   <translation>Mittel</translation>
  </message>
  <message>
   <source>Mean addendum</source>
   <translation>Mittlere Kopfhöhe</translation>
  </message>
  <message>
   <source>Mean addendum and dedendum</source>
   <translation>Mittlere Kopf- und Fußhöhe</translation>
  </message>
  <message>
   <source>Mean addendum factor</source>
   <translation>Mittlerer Kopfhöhenfaktor</translation>
  </message>
  <message>
   <source>Mean chordal addendum</source>
   <translation>Mittlere Höhe über der Sehne</translation>
  </message>
  <message>
   <source>Mean clearance</source>
   <translation>Mittleres Kopfspiel</translation>
  </message>
  <message>
   <source>Mean cone distance</source>
   <translation>Kegellänge, Mitte</translation>
  </message>
  <message>
   <source>Mean curvature</source>
   <translation>Mittlere Krümmung</translation>
  </message>
  <message>
   <source>Mean dedendum</source>
   <translation>Mittlere Fußhöhe</translation>
  </message>
  <message>
   <source>Mean deviation without its sign</source>
   <translation>Mittlere Abweichung dem Betrag nach</translation>
  </message>
  <message>
   <source>Mean normal chordal thickness</source>
   <translation>Normale Zahndickensehne, Mitte</translation>
  </message>
  <message>
   <source>Mean normal circular thickness</source>
   <translation>Normale Zahndicke, Mitte</translation>
  </message>
  <message>
   <source>Mean normal module</source>
   <translation>Normalmodul, Mitte</translation>
  </message>
  <message>
   <source>Mean normal thickness</source>
   <translation>Normale Zahndicke, Mitte</translation>
  </message>
  <message>
   <source>Mean of the absolute deviations</source>
   <translation>Mittel der Beträge der Abweichungen</translation>
  </message>
  <message>
   <source>Mean pitch diameter</source>
   <translation>Mittlerer Teilkreisdurchmesser</translation>
  </message>
  <message>
   <source>Mean radii</source>
   <translation>Mittlere Radien</translation>
  </message>
  <message>
   <source>Mean root diameter</source>
   <translation>Mittlerer Fußkreisdurchmesser</translation>
  </message>
  <message>
   <source>Mean spiral angle</source>
   <translation>Mittlerer Spiralwinkel</translation>
  </message>
  <message>
   <source>Mean tip diameter</source>
   <translation>Mittlerer Kopfkreisdurchmesser</translation>
  </message>
  <message>
   <source>Mean whole depth</source>
   <translation>Mittlere Zahnhöhe</translation>
  </message>
  <message>
   <source>Mean working depth</source>
   <translation>Mittlere gemeinsame Zahnhöhe</translation>
  </message>
  <message>
   <source>Mean, pitch cone</source>
   <translation>Mitte, Teilkegel</translation>
  </message>
  <message>
   <source>Mean: at the mean point on the pitch cone. Toe: at the toe on the base cone, as the paper gives it.</source>
   <translation>Mitte: im Mittelpunkt auf dem Teilkegel. Zehe: an der Zehe auf dem Grundkegel, wie in der Arbeit.</translation>
  </message>
  <message>
   <source>Measure</source>
   <translation>Messen</translation>
  </message>
  <message>
   <source>Measured in the tangent plane; it is the arc ψ at which the involute crosses the pitch cone.</source>
   <translation>In der Tangentialebene gemessen; es ist der Bogen ψ, bei dem die Evolvente den Teilkegel schneidet.</translation>
  </message>
  <message>
   <source>Measured points</source>
   <translation>Messpunkte</translation>
  </message>
  <message>
   <source>Measured points against the theory: errors of the flanks, a map, the pitch</source>
   <translation>Messpunkte gegen die Theorie: Fehler der Flanken, eine Karte, die Teilung</translation>
  </message>
  <message>
   <source>Measured points against theory</source>
   <translation>Messpunkte gegen Theorie</translation>
  </message>
  <message>
   <source>Measured points and models</source>
   <translation>Messpunkte und Modelle</translation>
  </message>
  <message>
   <source>Measured points on the gear, coloured by their deviation</source>
   <translation>Messpunkte auf dem Rad, nach Abweichung gefärbt</translation>
  </message>
  <message>
   <source>Measurement</source>
   <translation>Messung</translation>
  </message>
  <message>
   <source>Member</source>
   <translation>Rad</translation>
  </message>
  <message>
   <source>Member whose mean spiral angle is given; both have the same without an offset.</source>
   <translation>Rad, dessen mittlerer Spiralwinkel gegeben ist; ohne Achsversatz haben beide denselben.</translation>
  </message>
  <message>
   <source>Memory of the CAD kernel</source>
   <translation>Speicher des CAD-Kerns</translation>
  </message>
  <message>
   <source>Memory, graphics and recovery</source>
   <translation>Speicher, Grafik und Wiederherstellung</translation>
  </message>
  <message>
   <source>Menu</source>
   <translation>Menü</translation>
  </message>
  <message>
   <source>Metal at the corners root-toe and tip-heel more than at the other two.</source>
   <translation>Aufmaß an den Ecken Fuß-Zehe und Kopf-Ferse, mehr als an den anderen beiden.</translation>
  </message>
  <message>
   <source>Metal at the heel more than at the toe, over the whole face; nothing changes in the middle.</source>
   <translation>Aufmaß an der Ferse gegenüber der Zehe, über die ganze Breite; die Mitte bleibt.</translation>
  </message>
  <message>
   <source>Metal at the tip more than at the root, over the whole depth of the flank; nothing changes in the middle.</source>
   <translation>Aufmaß am Kopf gegenüber dem Fuß, über die ganze Flankenhöhe; die Mitte bleibt.</translation>
  </message>
  <message>
   <source>Metal taken off a flank</source>
   <translation>Werkstoff, der an einer Flanke fehlt</translation>
  </message>
  <message>
   <source>Metal taken off at root and tip of the flank, rising as a parabola from the middle of its depth.</source>
   <translation>An Fuß und Kopf abgetragenes Metall, parabolisch von der Mitte der Flankenhöhe aus.</translation>
  </message>
  <message>
   <source>Metal taken off at the lower edge of the flank; it fades out as a cube, without a kink.</source>
   <translation>Am unteren Rand der Flanke abgetragenes Metall; es klingt kubisch aus, ohne Knick.</translation>
  </message>
  <message>
   <source>Metal taken off at the tip; it grows from where it starts as a cube, without a kink in slope or curvature.</source>
   <translation>Am Kopf abgetragenes Metall; es wächst ab dem Beginn kubisch, ohne Knick in Steigung oder Krümmung.</translation>
  </message>
  <message>
   <source>Metal taken off at toe and heel, rising as a parabola from the middle of the face.</source>
   <translation>An Zehe und Ferse abgetragenes Metall, parabolisch von der Mitte der Breite aus.</translation>
  </message>
  <message>
   <source>Method</source>
   <translation>Methode</translation>
  </message>
  <message>
   <source>Method 1 as written; Method 0 without an offset</source>
   <translation>Methode 1 wie geschrieben; ohne Achsversatz Methode 0</translation>
  </message>
  <message>
   <source>Method comparison</source>
   <translation>Methodenvergleich</translation>
  </message>
  <message>
   <source>Methods</source>
   <translation>Methoden</translation>
  </message>
  <message>
   <source>Micro-geometry</source>
   <translation>Mikrogeometrie</translation>
  </message>
  <message>
   <source>Micro-geometry: pinion, concave</source>
   <translation>Mikrogeometrie: Ritzel, konkav</translation>
  </message>
  <message>
   <source>Micro-geometry: pinion, convex</source>
   <translation>Mikrogeometrie: Ritzel, konvex</translation>
  </message>
  <message>
   <source>Micro-geometry: wheel, concave</source>
   <translation>Mikrogeometrie: Rad, konkav</translation>
  </message>
  <message>
   <source>Micro-geometry: wheel, convex</source>
   <translation>Mikrogeometrie: Rad, konvex</translation>
  </message>
  <message>
   <source>Millimetres</source>
   <translation>Millimeter</translation>
  </message>
  <message>
   <source>Modified contact ratio</source>
   <translation>Überdeckung, modif.</translation>
  </message>
  <message>
   <source>Motion</source>
   <translation>Bewegung</translation>
  </message>
  <message>
   <source>Mounting distance</source>
   <translation>Einbaumaß</translation>
  </message>
  <message>
   <source>NOT VALID</source>
   <translation>NICHT GÜLTIG</translation>
  </message>
  <message>
   <source>NURBS surface</source>
   <translation>NURBS-Fläche</translation>
  </message>
  <message>
   <source>Name</source>
   <translation>Name</translation>
  </message>
  <message>
   <source>Names</source>
   <translation>Namen</translation>
  </message>
  <message>
   <source>Names of the members and of every face</source>
   <translation>Namen der Räder und jeder Fläche</translation>
  </message>
  <message>
   <source>New &amp;window</source>
   <translation>Neues &amp;Fenster</translation>
  </message>
  <message>
   <source>New key</source>
   <translation>Neue Tasten</translation>
  </message>
  <message>
   <source>Next</source>
   <translation>Weiter</translation>
  </message>
  <message>
   <source>Next place where the words stand</source>
   <translation>Nächste Fundstelle</translation>
  </message>
  <message>
   <source>No 3D views</source>
   <translation>Keine 3D-Ansichten</translation>
  </message>
  <message>
   <source>No contact</source>
   <translation>Kein Kontakt</translation>
  </message>
  <message>
   <source>No limit</source>
   <translation>Unbegrenzt</translation>
  </message>
  <message>
   <source>No misalignment, usual marking compound</source>
   <translation>Keine Einbaufehler, übliche Tuschierpaste</translation>
  </message>
  <message>
   <source>No parameter has these words</source>
   <translation>Kein Parameter enthält diese Wörter</translation>
  </message>
  <message>
   <source>No picture: {why}</source>
   <translation>Kein Bild: {why}</translation>
  </message>
  <message>
   <source>No pictures were handed in.</source>
   <translation>Es wurden keine Bilder mitgegeben.</translation>
  </message>
  <message>
   <source>No points</source>
   <translation>Keine Punkte</translation>
  </message>
  <message>
   <source>No points yet: open a file of measured points in mm, or a STEP file; apex at the origin, axis along z.</source>
   <translation>Noch keine Punkte: Datei mit Messpunkten in mm oder STEP-Datei öffnen; Spitze im Ursprung, Achse entlang z.</translation>
  </message>
  <message>
   <source>Nominal grid…</source>
   <translation>Sollnetz…</translation>
  </message>
  <message>
   <source>None: all four flanks are the theoretical ones.</source>
   <translation>Keine: alle vier Flanken sind die theoretischen.</translation>
  </message>
  <message>
   <source>Normal chordal thickness, mean</source>
   <translation>Zahndickensehne im Normalschnitt, Mitte</translation>
  </message>
  <message>
   <source>Normal circular thickness, mean</source>
   <translation>Zahndicke im Normalschnitt, Mitte</translation>
  </message>
  <message>
   <source>Normal pressure angle, coast flank</source>
   <translation>Normaleingriffswinkel, Schubflanke</translation>
  </message>
  <message>
   <source>Normal pressure angle, drive flank</source>
   <translation>Normaleingriffswinkel, Zugflanke</translation>
  </message>
  <message>
   <source>Normal pressure angle, mean point</source>
   <translation>Normaleingriffswinkel, Mittelpunkt</translation>
  </message>
  <message>
   <source>Normal to the flank, positive where metal is added; exact to second order, beyond which the foot point is iterated.</source>
   <translation>Normal zur Flanke, positiv bei Aufmaß; genau bis zur zweiten Ordnung, darüber hinaus wird der Fußpunkt iteriert.</translation>
  </message>
  <message>
   <source>Normal to the flank: crowning along the face and over the profile, corrections of spiral and pressure angle, bias, tip and root relief. ξ runs from −1 at the toe to 1 at the heel, η from −1 at the flank's lower edge to 1 at the tip. D is the drive flank, concave on the pinion and convex on the wheel; C is the coast flank.</source>
   <translation>Normal zur Flanke: Balligkeit entlang der Breite und über dem Profil, Korrekturen von Spiral- und Eingriffswinkel, Verwindung, Kopf- und Fußrücknahme. ξ läuft von −1 an der Zehe bis 1 an der Ferse, η von −1 am unteren Rand der Flanke bis 1 am Kopf. D ist die Zugflanke, am Ritzel konkav und am Rad konvex; C ist die Schubflanke.</translation>
  </message>
  <message>
   <source>Normal, mean point</source>
   <translation>Normal, Mittelpunkt</translation>
  </message>
  <message>
   <source>Normal: in the normal section at the mean point, as standards give it. Transverse: as the paper gives it.</source>
   <translation>Normal: im Normalschnitt des Mittelpunkts, wie in Normen. Transversal: wie in der Arbeit.</translation>
  </message>
  <message>
   <source>Normals</source>
   <translation>Normalen</translation>
  </message>
  <message>
   <source>Not built yet</source>
   <translation>Nicht gebaut</translation>
  </message>
  <message>
   <source>Not used now.</source>
   <translation>Jetzt nicht benutzt.</translation>
  </message>
  <message>
   <source>Note</source>
   <translation>Hinweis</translation>
  </message>
  <message>
   <source>Nothing found</source>
   <translation>Nichts gefunden</translation>
  </message>
  <message>
   <source>Nothing is lost: save the design in another folder.</source>
   <translation>Nichts ist verloren: den Entwurf in einem anderen Ordner speichern.</translation>
  </message>
  <message>
   <source>Now: {value}</source>
   <translation>Jetzt: {value}</translation>
  </message>
  <message>
   <source>Number of faces of the solid</source>
   <translation>Anzahl der Flächen des Körpers</translation>
  </message>
  <message>
   <source>Number of stripes</source>
   <translation>Anzahl der Streifen</translation>
  </message>
  <message>
   <source>Number of teeth</source>
   <translation>Zähnezahl</translation>
  </message>
  <message>
   <source>Number of teeth of the pinion.</source>
   <translation>Zähnezahl des Ritzels.</translation>
  </message>
  <message>
   <source>Number of teeth of the wheel.</source>
   <translation>Zähnezahl des Rads.</translation>
  </message>
  <message>
   <source>OUT OF LIMITS</source>
   <translation>AUSSERHALB</translation>
  </message>
  <message>
   <source>Obtuse shafts, logarithmic spiral</source>
   <translation>Stumpfer Achsenwinkel, logarithmische Spirale</translation>
  </message>
  <message>
   <source>Of mass, from the apex</source>
   <translation>Von der Spitze aus</translation>
  </message>
  <message>
   <source>Of pitch, tip and root circle, with cone distance and depths of the place; the numbers are those of the heel.</source>
   <translation>Von Teil-, Kopf- und Fußkreis, mit Kegellänge und Zahnhöhen des Orts; die Zahlen sind die der Ferse.</translation>
  </message>
  <message>
   <source>Of the disc between hub and rim, from the back face.</source>
   <translation>Der Scheibe zwischen Nabe und Kranz, von der Rückfläche.</translation>
  </message>
  <message>
   <source>Of the edges between tip and ends of the teeth, turned over all teeth at toe and heel; its legs along the face cone and along the end, 0 for none.</source>
   <translation>Der Kanten zwischen Kopf und Zahnenden, an Zehe und Ferse über alle Zähne gedreht; die Schenkel liegen am Kopfkegel und am Ende, 0 für keine.</translation>
  </message>
  <message>
   <source>Of the section square to the tooth at the mean point.</source>
   <translation>Im Schnitt rechtwinklig zum Zahn im Mittelpunkt.</translation>
  </message>
  <message>
   <source>Of the whole surface</source>
   <translation>Der ganzen Oberfläche</translation>
  </message>
  <message>
   <source>Offset</source>
   <translation>Achsversatz</translation>
  </message>
  <message>
   <source>Offset angle, axial plane</source>
   <translation>Versatzwinkel, Axialebene</translation>
  </message>
  <message>
   <source>Offset angle, face plane</source>
   <translation>Versatzwinkel, Kopfebene</translation>
  </message>
  <message>
   <source>Offset angle, pitch plane</source>
   <translation>Versatzwinkel, Teilebene</translation>
  </message>
  <message>
   <source>Offset angle, root plane</source>
   <translation>Versatzwinkel, Fußebene</translation>
  </message>
  <message>
   <source>Offset axes</source>
   <translation>Achsen mit Versatz</translation>
  </message>
  <message>
   <source>Offset in the pitch plane</source>
   <translation>Versatz in der Teilebene</translation>
  </message>
  <message>
   <source>On by a twelfth of a tooth</source>
   <translation>Um eine Zwölftelteilung weiter</translation>
  </message>
  <message>
   <source>On the base cone, as the paper gives it; β_i is the spiral angle on the pitch cone there.</source>
   <translation>Auf dem Grundkegel, wie die Arbeit ihn angibt; β_i ist der Spiralwinkel auf dem Teilkegel dort.</translation>
  </message>
  <message>
   <source>One camera for all</source>
   <translation>Eine Kamera für alle</translation>
  </message>
  <message>
   <source>One closed shell</source>
   <translation>Eine geschlossene Hülle</translation>
  </message>
  <message>
   <source>One flank of the three methods, coloured by its deviation from the exact flank.</source>
   <translation>Eine Flanke der drei Methoden, gefärbt nach ihrer Abweichung von der exakten Flanke.</translation>
  </message>
  <message>
   <source>One of: {choices}.</source>
   <translation>Eines von: {choices}.</translation>
  </message>
  <message>
   <source>One tooth</source>
   <translation>Ein Zahn</translation>
  </message>
  <message>
   <source>One tooth was measured: there is no pitch to compare</source>
   <translation>Ein Zahn wurde gemessen: es gibt keine Teilung zu vergleichen</translation>
  </message>
  <message>
   <source>One unit of the file is a metre, as glTF asks; mm is for programs that do not scale</source>
   <translation>Eine Einheit der Datei ist ein Meter, wie glTF es verlangt; mm für Programme, die nicht skalieren</translation>
  </message>
  <message>
   <source>Only one window can save it. Read-only, Save asks for another name; a copy starts as a new design.</source>
   <translation>Nur ein Fenster kann ihn speichern. Schreibgeschützt fragt Speichern nach einem anderen Namen; eine Kopie beginnt als neuer Entwurf.</translation>
  </message>
  <message>
   <source>Only the Archimedean spiral can take its angle at the toe.</source>
   <translation>Nur die archimedische Spirale kann ihren Winkel an der Zehe haben.</translation>
  </message>
  <message>
   <source>Only the rolled arc is divided by sin δ_b: the second term is an angle about the axis already.</source>
   <translation>Nur der abgerollte Bogen wird durch sin δ_b geteilt: der zweite Term ist schon ein Winkel um die Achse.</translation>
  </message>
  <message>
   <source>Opacity</source>
   <translation>Deckkraft</translation>
  </message>
  <message>
   <source>Open &amp;read-only</source>
   <translation>&amp;Schreibgeschützt öffnen</translation>
  </message>
  <message>
   <source>Open &amp;recent</source>
   <translation>&amp;Zuletzt benutzt</translation>
  </message>
  <message>
   <source>Open &amp;recovered</source>
   <translation>&amp;Wiederhergestelltes öffnen</translation>
  </message>
  <message>
   <source>Open &amp;saved</source>
   <translation>&amp;Gespeichertes öffnen</translation>
  </message>
  <message>
   <source>Open a &amp;copy</source>
   <translation>&amp;Kopie öffnen</translation>
  </message>
  <message>
   <source>Open a design file (.gear.toml)</source>
   <translation>Eine Entwurfsdatei öffnen (.gear.toml)</translation>
  </message>
  <message>
   <source>Open another window, with a CAD process of its own</source>
   <translation>Ein weiteres Fenster mit eigenem CAD-Prozess öffnen</translation>
  </message>
  <message>
   <source>Open design</source>
   <translation>Entwurf öffnen</translation>
  </message>
  <message>
   <source>Open measured points on the page Measurement first</source>
   <translation>Zuerst Messpunkte auf der Seite Messung öffnen</translation>
  </message>
  <message>
   <source>Open measured points or a STEP file</source>
   <translation>Messpunkte oder STEP-Datei öffnen</translation>
  </message>
  <message>
   <source>Open points or STEP…</source>
   <translation>Punkte oder STEP öffnen…</translation>
  </message>
  <message>
   <source>Open the file as it was saved; the recovered edits stay</source>
   <translation>Die Datei öffnen, wie sie gespeichert wurde; das Wiederhergestellte bleibt</translation>
  </message>
  <message>
   <source>OpenGL {needed} is needed, and {renderer} offers {version}.</source>
   <translation>OpenGL {needed} ist nötig, {renderer} bietet {version}.</translation>
  </message>
  <message>
   <source>Optimised</source>
   <translation>Optimiert</translation>
  </message>
  <message>
   <source>Other</source>
   <translation>Anderer</translation>
  </message>
  <message>
   <source>Other design</source>
   <translation>Anderer Entwurf</translation>
  </message>
  <message>
   <source>Out of date: the design has changed</source>
   <translation>Veraltet: der Entwurf wurde geändert</translation>
  </message>
  <message>
   <source>Out of date: the design was changed after these pages were made. Update the preview.</source>
   <translation>Veraltet: der Entwurf wurde nach diesen Seiten geändert. Vorschau erneuern.</translation>
  </message>
  <message>
   <source>Outer addendum</source>
   <translation>Äußere Kopfhöhe</translation>
  </message>
  <message>
   <source>Outer clearance</source>
   <translation>Äußeres Kopfspiel</translation>
  </message>
  <message>
   <source>Outer cone distance</source>
   <translation>Kegellänge, außen</translation>
  </message>
  <message>
   <source>Outer dedendum</source>
   <translation>Äußere Fußhöhe</translation>
  </message>
  <message>
   <source>Outer diameter of the hub, on the side of the apex.</source>
   <translation>Außendurchmesser der Nabe, auf der Seite der Spitze.</translation>
  </message>
  <message>
   <source>Outer module</source>
   <translation>Außenmodul</translation>
  </message>
  <message>
   <source>Outer module: the factors of the tooth, over the outer module at the heel. ISO 23509: factors of the mean normal module at the mean point, with a taper.</source>
   <translation>Außenmodul: die Faktoren des Zahns, mal Außenmodul an der Ferse. ISO 23509: Faktoren des mittleren Normalmoduls im Mittelpunkt, mit Verjüngung.</translation>
  </message>
  <message>
   <source>Outer pitch diameter</source>
   <translation>Äußerer Teilkreisdurchmesser</translation>
  </message>
  <message>
   <source>Outer root diameter</source>
   <translation>Äußerer Fußkreisdurchmesser</translation>
  </message>
  <message>
   <source>Outer spiral angle</source>
   <translation>Äußerer Spiralwinkel</translation>
  </message>
  <message>
   <source>Outer tip diameter</source>
   <translation>Äußerer Kopfkreisdurchmesser</translation>
  </message>
  <message>
   <source>Outer transverse module</source>
   <translation>Äußerer Stirnmodul</translation>
  </message>
  <message>
   <source>Outer transverse module of the wheel</source>
   <translation>Äußerer Stirnmodul des Rads</translation>
  </message>
  <message>
   <source>Outer transverse module: heel pitch diameter over teeth.</source>
   <translation>Äußerer Stirnmodul: Teilkreisdurchmesser an der Ferse durch Zähnezahl.</translation>
  </message>
  <message>
   <source>Outer whole depth</source>
   <translation>Äußere Zahnhöhe</translation>
  </message>
  <message>
   <source>Overlap ratio</source>
   <translation>Sprungüberdeckung</translation>
  </message>
  <message>
   <source>Own base cone</source>
   <translation>Eigener Grundkegel</translation>
  </message>
  <message>
   <source>P  pinion axial</source>
   <translation>P  Ritzel axial</translation>
  </message>
  <message>
   <source>PDF files (*.pdf)</source>
   <translation>PDF-Dateien (*.pdf)</translation>
  </message>
  <message>
   <source>Page</source>
   <translation>Seite</translation>
  </message>
  <message>
   <source>Page {number} of {count}</source>
   <translation>Seite {number} von {count}</translation>
  </message>
  <message>
   <source>Pages of the preferences</source>
   <translation>Seiten der Einstellungen</translation>
  </message>
  <message>
   <source>Pair</source>
   <translation>Paar</translation>
  </message>
  <message>
   <source>Pair in mesh</source>
   <translation>Paar im Eingriff</translation>
  </message>
  <message>
   <source>Pair in mesh, on by one tooth</source>
   <translation>Paar im Eingriff, um einen Zahn weiter</translation>
  </message>
  <message>
   <source>Panels that share a place</source>
   <translation>Felder, die sich einen Platz teilen</translation>
  </message>
  <message>
   <source>Paper</source>
   <translation>Arbeit</translation>
  </message>
  <message>
   <source>Parallel</source>
   <translation>Parallel</translation>
  </message>
  <message>
   <source>Parallel shows true proportions</source>
   <translation>Parallel zeigt wahre Verhältnisse</translation>
  </message>
  <message>
   <source>Parameter</source>
   <translation>Parameter</translation>
  </message>
  <message>
   <source>Parameters</source>
   <translation>Parameter</translation>
  </message>
  <message>
   <source>Parameters and derived values beside those of another design</source>
   <translation>Parameter und abgeleitete Werte neben denen eines anderen Entwurfs</translation>
  </message>
  <message>
   <source>Parameters and derived values of both designs</source>
   <translation>Parameter und abgeleitete Werte beider Entwürfe</translation>
  </message>
  <message>
   <source>Parameters that differ</source>
   <translation>Abweichende Parameter</translation>
  </message>
  <message>
   <source>Parameters that the equation uses</source>
   <translation>Parameter, die die Gleichung benutzt</translation>
  </message>
  <message>
   <source>Parameters: {group}</source>
   <translation>Parameter: {group}</translation>
  </message>
  <message>
   <source>Part</source>
   <translation>Teil</translation>
  </message>
  <message>
   <source>Paste</source>
   <translation>Einfügen</translation>
  </message>
  <message>
   <source>Pattern</source>
   <translation>Tragbild</translation>
  </message>
  <message>
   <source>Pattern [%]</source>
   <translation>Tragbild [%]</translation>
  </message>
  <message>
   <source>Peak to peak</source>
   <translation>Spitze–Spitze</translation>
  </message>
  <message>
   <source>Perspective</source>
   <translation>Perspektive</translation>
  </message>
  <message>
   <source>Pi&amp;cture…</source>
   <translation>&amp;Bild…</translation>
  </message>
  <message>
   <source>Picture</source>
   <translation>Bild</translation>
  </message>
  <message>
   <source>Picture (*.png);;Drawing (*.svg);;Table (*.csv)</source>
   <translation>Bild (*.png);;Zeichnung (*.svg);;Tabelle (*.csv)</translation>
  </message>
  <message>
   <source>Picture of</source>
   <translation>Bild von</translation>
  </message>
  <message>
   <source>Pinion</source>
   <translation>Ritzel</translation>
  </message>
  <message>
   <source>Pinion along its axis, positive away from the crossing point</source>
   <translation>Ritzel entlang seiner Achse, positiv vom Achsschnittpunkt weg</translation>
  </message>
  <message>
   <source>Pinion axis beside the wheel's, positive as a positive hypoid offset</source>
   <translation>Ritzelachse neben der Radachse, positiv wie ein positiver Achsversatz</translation>
  </message>
  <message>
   <source>Pinion blank</source>
   <translation>Radkörper Ritzel</translation>
  </message>
  <message>
   <source>Pinion teeth</source>
   <translation>Zähne Ritzel</translation>
  </message>
  <message>
   <source>Pinion {pinion:.1f}° · wheel {wheel:.1f}°</source>
   <translation>Ritzel {pinion:.1f}° · Rad {wheel:.1f}°</translation>
  </message>
  <message>
   <source>Pitch</source>
   <translation>Teilung</translation>
  </message>
  <message>
   <source>Pitch angle</source>
   <translation>Teilkegelwinkel</translation>
  </message>
  <message>
   <source>Pitch apex</source>
   <translation>Teilkegelspitze</translation>
  </message>
  <message>
   <source>Pitch apex beyond crossing point</source>
   <translation>Teilkegelspitze über dem Kreuzungspunkt</translation>
  </message>
  <message>
   <source>Pitch cone</source>
   <translation>Teilkegel</translation>
  </message>
  <message>
   <source>Pitch cone angle</source>
   <translation>Winkel des Teilkegels</translation>
  </message>
  <message>
   <source>Pitch cones in contact</source>
   <translation>Teilkegel in Berührung</translation>
  </message>
  <message>
   <source>Pitch diameter, heel</source>
   <translation>Teilkreis-⌀, Ferse</translation>
  </message>
  <message>
   <source>Pitch error</source>
   <translation>Teilungsabweichung</translation>
  </message>
  <message>
   <source>Pitch to base element</source>
   <translation>Teil–Grundlinie</translation>
  </message>
  <message>
   <source>Pitch to base element, in the tangent plane</source>
   <translation>Teil- zu Grundkegellinie, in der Tangentialebene</translation>
  </message>
  <message>
   <source>Pitch, single</source>
   <translation>Teilung, einzeln</translation>
  </message>
  <message>
   <source>Pitch, total</source>
   <translation>Teilung, gesamt</translation>
  </message>
  <message>
   <source>Pixels of the picture for one on the screen</source>
   <translation>Bildpunkte des Bilds für einen am Schirm</translation>
  </message>
  <message>
   <source>Place along the face</source>
   <translation>Ort entlang der Breite</translation>
  </message>
  <message>
   <source>Place along the profile</source>
   <translation>Ort entlang des Profils</translation>
  </message>
  <message>
   <source>Place of the section</source>
   <translation>Ort des Schnitts</translation>
  </message>
  <message>
   <source>Place on a flank</source>
   <translation>Ort auf einer Flanke</translation>
  </message>
  <message>
   <source>Places along the generating line</source>
   <translation>Orte entlang der Erzeugenden</translation>
  </message>
  <message>
   <source>Play</source>
   <translation>Abspielen</translation>
  </message>
  <message>
   <source>Point</source>
   <translation>Punkt</translation>
  </message>
  <message>
   <source>Point cloud</source>
   <translation>Punktwolke</translation>
  </message>
  <message>
   <source>Point cloud degree</source>
   <translation>Grad der Punktwolke</translation>
  </message>
  <message>
   <source>Point in spherical coordinates</source>
   <translation>Punkt in Kugelkoordinaten</translation>
  </message>
  <message>
   <source>Point series</source>
   <translation>Punktfolge</translation>
  </message>
  <message>
   <source>Points</source>
   <translation>Punkte</translation>
  </message>
  <message>
   <source>Points and surfaces</source>
   <translation>Punkte und Flächen</translation>
  </message>
  <message>
   <source>Points left out beside the flanks</source>
   <translation>Ausgelassene Punkte neben den Flanken</translation>
  </message>
  <message>
   <source>Points of the exact flank on U and V lines</source>
   <translation>Punkte der exakten Flanke auf U- und V-Linien</translation>
  </message>
  <message>
   <source>Points on the flanks</source>
   <translation>Punkte auf den Flanken</translation>
  </message>
  <message>
   <source>Points, U and V lines</source>
   <translation>Punkte, U- und V-Linien</translation>
  </message>
  <message>
   <source>Poles</source>
   <translation>Pole</translation>
  </message>
  <message>
   <source>Positions, sections, or points along each side of the grid</source>
   <translation>Stellungen, Schnitte oder Punkte je Seite des Netzes</translation>
  </message>
  <message>
   <source>Preferences</source>
   <translation>Einstellungen</translation>
  </message>
  <message>
   <source>Preparing 3D view…</source>
   <translation>3D-Ansicht wird vorbereitet…</translation>
  </message>
  <message>
   <source>Preparing the analysis…</source>
   <translation>Auswertung wird vorbereitet…</translation>
  </message>
  <message>
   <source>Press the new keys here</source>
   <translation>Die neuen Tasten hier drücken</translation>
  </message>
  <message>
   <source>Pressure angle</source>
   <translation>Eingriffswinkel</translation>
  </message>
  <message>
   <source>Pressure angle correction</source>
   <translation>Korrektur des Eingriffswinkels</translation>
  </message>
  <message>
   <source>Pressure angle is</source>
   <translation>Eingriffswinkel ist</translation>
  </message>
  <message>
   <source>Pressure angle of both flanks.</source>
   <translation>Eingriffswinkel beider Flanken.</translation>
  </message>
  <message>
   <source>Pressure angle, normal</source>
   <translation>Normaleingriffsw.</translation>
  </message>
  <message>
   <source>Pressure angle, transv.</source>
   <translation>Stirneingriffswinkel</translation>
  </message>
  <message>
   <source>Pressure angles and base cones of both flanks</source>
   <translation>Eingriffswinkel und Grundkegel beider Flanken</translation>
  </message>
  <message>
   <source>Preview of the report</source>
   <translation>Vorschau des Berichts</translation>
  </message>
  <message>
   <source>Principal 1 (largest)</source>
   <translation>Haupt- 1 (größte)</translation>
  </message>
  <message>
   <source>Principal 2 (smallest)</source>
   <translation>Haupt- 2 (kleinste)</translation>
  </message>
  <message>
   <source>Printed 0.963 rad; used 0.286 rad, which gives back β₀ at the toe (17/40 teeth, m = 4 mm, wheel).</source>
   <translation>Gedruckt 0,963 rad; benutzt 0,286 rad, was β₀ an der Zehe wiedergibt (17/40 Zähne, m = 4 mm, Rad).</translation>
  </message>
  <message>
   <source>Printed 21.1°; used 59.863°, which equals arcsin(sin δ cos α) (17/40 teeth, m = 4 mm, transverse 20°, wheel).</source>
   <translation>Gedruckt 21,1°; benutzt 59,863°, gleich arcsin(sin δ cos α) (17/40 Zähne, m = 4 mm, Stirn 20°, Rad).</translation>
  </message>
  <message>
   <source>Profile at the toe</source>
   <translation>Profil an der Zehe</translation>
  </message>
  <message>
   <source>Profile crown</source>
   <translation>Höhenballigkeit</translation>
  </message>
  <message>
   <source>Profile crowning</source>
   <translation>Höhenballigkeit</translation>
  </message>
  <message>
   <source>Profile shift</source>
   <translation>Profilverschiebung</translation>
  </message>
  <message>
   <source>Profile shift coefficient</source>
   <translation>Profilverschiebungsbeiwert</translation>
  </message>
  <message>
   <source>Profile shift factor</source>
   <translation>Profilverschiebungsfaktor</translation>
  </message>
  <message>
   <source>Profile shift factor of the pinion; the wheel takes the negative.</source>
   <translation>Profilverschiebungsfaktor des Ritzels; das Rad hat den negativen.</translation>
  </message>
  <message>
   <source>Profile sweep</source>
   <translation>Profil-Sweep</translation>
  </message>
  <message>
   <source>Progress of the measurement</source>
   <translation>Fortschritt der Messung</translation>
  </message>
  <message>
   <source>Progress of the study</source>
   <translation>Fortschritt der Untersuchung</translation>
  </message>
  <message>
   <source>Projection</source>
   <translation>Projektion</translation>
  </message>
  <message>
   <source>Properties</source>
   <translation>Eigenschaften</translation>
  </message>
  <message>
   <source>Properties of the solids</source>
   <translation>Eigenschaften der Körper</translation>
  </message>
  <message>
   <source>Published</source>
   <translation>Gedruckt</translation>
  </message>
  <message>
   <source>Published values</source>
   <translation>Gedruckte Werte</translation>
  </message>
  <message>
   <source>Published values and those computed</source>
   <translation>Gedruckte und berechnete Werte</translation>
  </message>
  <message>
   <source>Purple – green</source>
   <translation>Violett – Grün</translation>
  </message>
  <message>
   <source>Put every panel back in its place</source>
   <translation>Jede Tafel an ihren Ort zurücklegen</translation>
  </message>
  <message>
   <source>Put it in place of what is open; Undo takes that back. No file is changed.</source>
   <translation>An die Stelle des Offenen setzen; Rückgängig nimmt es zurück. Keine Datei ändert sich.</translation>
  </message>
  <message>
   <source>Put the cursor into a parameter first</source>
   <translation>Erst den Cursor in einen Parameter setzen</translation>
  </message>
  <message>
   <source>Quantity</source>
   <translation>Größe</translation>
  </message>
  <message>
   <source>RMS</source>
   <translation>RMS</translation>
  </message>
  <message>
   <source>RMS deviation</source>
   <translation>Quadratisches Mittel der Abweichung</translation>
  </message>
  <message>
   <source>R_e from the pitch apex</source>
   <translation>R_e ab der Teilkegelspitze</translation>
  </message>
  <message>
   <source>R_f as asked, or of the full-round root</source>
   <translation>R_f wie verlangt, oder des vollgerundeten Fußes</translation>
  </message>
  <message>
   <source>R_i from the pitch apex</source>
   <translation>R_i ab der Teilkegelspitze</translation>
  </message>
  <message>
   <source>R_m from the pitch apex</source>
   <translation>R_m ab der Teilkegelspitze</translation>
  </message>
  <message>
   <source>Radial</source>
   <translation>Radial</translation>
  </message>
  <message>
   <source>Radius of the back plane of the base cone.</source>
   <translation>Radius der Rückebene des Grundkegels.</translation>
  </message>
  <message>
   <source>Radius of the cutter whose arc the tooth follows.</source>
   <translation>Radius des Messerkopfs, dessen Bogen der Zahn folgt.</translation>
  </message>
  <message>
   <source>Radius of the tangent circular plane, which is the heel sphere's.</source>
   <translation>Radius der tangentialen Kreisebene, zugleich der Fersenkugel.</translation>
  </message>
  <message>
   <source>Range: {limits}</source>
   <translation>Bereich: {limits}</translation>
  </message>
  <message>
   <source>Re&amp;start CAD kernel</source>
   <translation>CAD-Kern neu &amp;starten</translation>
  </message>
  <message>
   <source>Reaches {tolerance} µm with</source>
   <translation>Erreicht {tolerance} µm mit</translation>
  </message>
  <message>
   <source>Read back</source>
   <translation>Zurückgelesen</translation>
  </message>
  <message>
   <source>Reading {file}…</source>
   <translation>{file} wird gelesen…</translation>
  </message>
  <message>
   <source>Rebuild when the design changes</source>
   <translation>Bei Änderung neu bauen</translation>
  </message>
  <message>
   <source>Recent design {number}</source>
   <translation>Zuletzt geöffneter Entwurf {number}</translation>
  </message>
  <message>
   <source>Reco&amp;ver unsaved work…</source>
   <translation>Un&amp;gesicherte Arbeit wiederherstellen…</translation>
  </message>
  <message>
   <source>Recover unsaved edits</source>
   <translation>Ungesicherte Änderungen wiederherstellen</translation>
  </message>
  <message>
   <source>Recover unsaved work</source>
   <translation>Ungesicherte Arbeit wiederherstellen</translation>
  </message>
  <message>
   <source>Recovered</source>
   <translation>Wiederhergestellt</translation>
  </message>
  <message>
   <source>Recovered version</source>
   <translation>Wiederhergestellter Stand</translation>
  </message>
  <message>
   <source>Refined until the expected deviation is below the tolerance</source>
   <translation>Verfeinert, bis die erwartete Abweichung unter der Toleranz liegt</translation>
  </message>
  <message>
   <source>Reflections of straight lamps in the CAD flanks</source>
   <translation>Spiegelungen gerader Lampen in den CAD-Flanken</translation>
  </message>
  <message>
   <source>Remove &amp;missing ones</source>
   <translation>&amp;Fehlende entfernen</translation>
  </message>
  <message>
   <source>Report</source>
   <translation>Bericht</translation>
  </message>
  <message>
   <source>Reset</source>
   <translation>Zurücksetzen</translation>
  </message>
  <message>
   <source>Reset &amp;field</source>
   <translation>&amp;Feld zurücksetzen</translation>
  </message>
  <message>
   <source>Reset a&amp;ll parameters</source>
   <translation>A&amp;lle Parameter zurücksetzen</translation>
  </message>
  <message>
   <source>Reset all keys</source>
   <translation>Alle Tasten zurücksetzen</translation>
  </message>
  <message>
   <source>Reset all parameters</source>
   <translation>Alle Parameter zurücksetzen</translation>
  </message>
  <message>
   <source>Reset group {group}</source>
   <translation>Gruppe {group} zurücksetzen</translation>
  </message>
  <message>
   <source>Reset settings</source>
   <translation>Einstellungen zurücksetzen</translation>
  </message>
  <message>
   <source>Reset this group</source>
   <translation>Diese Gruppe zurücksetzen</translation>
  </message>
  <message>
   <source>Reset to &amp;sample</source>
   <translation>Auf &amp;Beispiel zurücksetzen</translation>
  </message>
  <message>
   <source>Reset to {preset}</source>
   <translation>Auf {preset} zurücksetzen</translation>
  </message>
  <message>
   <source>Reset to {value}</source>
   <translation>Auf {value} zurücksetzen</translation>
  </message>
  <message>
   <source>Reset {field}</source>
   <translation>{field} zurücksetzen</translation>
  </message>
  <message>
   <source>Restore defaults</source>
   <translation>Vorgaben wiederherstellen</translation>
  </message>
  <message>
   <source>Return goes to the next place</source>
   <translation>Enter geht zur nächsten Stelle</translation>
  </message>
  <message>
   <source>Right</source>
   <translation>Rechts</translation>
  </message>
  <message>
   <source>Right hand</source>
   <translation>Rechtssteigend</translation>
  </message>
  <message>
   <source>Rms</source>
   <translation>Rms</translation>
  </message>
  <message>
   <source>Roll angle from root to tip</source>
   <translation>Wälzwinkel vom Fuß zum Kopf</translation>
  </message>
  <message>
   <source>Roll of the tangent plane</source>
   <translation>Rollen der Tangentialebene</translation>
  </message>
  <message>
   <source>Roll of the tangent plane: {degrees:.1f}°</source>
   <translation>Rollen der Tangentialebene: {degrees:.1f}°</translation>
  </message>
  <message>
   <source>Roll the plane and let the line sweep out the flank</source>
   <translation>Die Ebene rollen; die Gerade überstreicht die Flanke</translation>
  </message>
  <message>
   <source>Rolling construction at δ_k = 68°: azimuth 0.0413879 rad, as the used form; the printed form gives −0.0838 rad (17/40 teeth, transverse 20°, wheel).</source>
   <translation>Rollkonstruktion bei δ_k = 68°: Azimut 0,0413879 rad, wie die benutzte Form; die gedruckte gibt −0,0838 rad (17/40 Zähne, Stirn 20°, Rad).</translation>
  </message>
  <message>
   <source>Rolling of the tangent plane</source>
   <translation>Rollen der Tangentialebene</translation>
  </message>
  <message>
   <source>Root angle</source>
   <translation>Fußkegelwinkel</translation>
  </message>
  <message>
   <source>Root apex beyond crossing point</source>
   <translation>Fußkegelspitze über dem Achsschnittpunkt</translation>
  </message>
  <message>
   <source>Root of the mean square</source>
   <translation>Wurzel des mittleren Quadrats</translation>
  </message>
  <message>
   <source>Root of the mean square deviation</source>
   <translation>Wurzel der mittleren quadratischen Abweichung</translation>
  </message>
  <message>
   <source>Root relief</source>
   <translation>Fußrücknahme</translation>
  </message>
  <message>
   <source>Root relief ends at</source>
   <translation>Fußrücknahme endet bei</translation>
  </message>
  <message>
   <source>Root – tip</source>
   <translation>Fuß – Kopf</translation>
  </message>
  <message>
   <source>Rotating line</source>
   <translation>Rollende Gerade</translation>
  </message>
  <message>
   <source>Run</source>
   <translation>Starten</translation>
  </message>
  <message>
   <source>Run the study: each method is built with growing effort</source>
   <translation>Untersuchung starten: jede Methode wird mit wachsendem Aufwand gebaut</translation>
  </message>
  <message>
   <source>S&amp;kip</source>
   <translation>Ü&amp;berspringen</translation>
  </message>
  <message>
   <source>STEP schema</source>
   <translation>STEP-Schema</translation>
  </message>
  <message>
   <source>STEP unit</source>
   <translation>STEP-Einheit</translation>
  </message>
  <message>
   <source>STL as</source>
   <translation>STL als</translation>
  </message>
  <message>
   <source>Samples, export and the report are under File; the guide, the equations and this tour under Help.</source>
   <translation>Beispiele, Export und Bericht stehen unter Datei; Anleitung, Gleichungen und dieser Rundgang unter Hilfe.</translation>
  </message>
  <message>
   <source>Save &amp;as…</source>
   <translation>Speichern &amp;unter…</translation>
  </message>
  <message>
   <source>Save a turntable, the pair in mesh or the rolling plane as MP4 or GIF</source>
   <translation>Drehteller, Paar im Eingriff oder rollende Ebene als MP4 oder GIF speichern</translation>
  </message>
  <message>
   <source>Save as .mp4 or .gif</source>
   <translation>Als .mp4 oder .gif speichern</translation>
  </message>
  <message>
   <source>Save as .png or .jpg</source>
   <translation>Als .png oder .jpg speichern</translation>
  </message>
  <message>
   <source>Save as PNG, SVG or CSV…</source>
   <translation>Als PNG, SVG oder CSV speichern…</translation>
  </message>
  <message>
   <source>Save chart</source>
   <translation>Diagramm speichern</translation>
  </message>
  <message>
   <source>Save data sheet</source>
   <translation>Datenblatt speichern</translation>
  </message>
  <message>
   <source>Save design</source>
   <translation>Entwurf speichern</translation>
  </message>
  <message>
   <source>Save film</source>
   <translation>Film speichern</translation>
  </message>
  <message>
   <source>Save nominal grid</source>
   <translation>Sollnetz speichern</translation>
  </message>
  <message>
   <source>Save or copy a picture of the views or the window</source>
   <translation>Ein Bild der Ansichten oder des Fensters speichern oder kopieren</translation>
  </message>
  <message>
   <source>Save picture</source>
   <translation>Bild speichern</translation>
  </message>
  <message>
   <source>Save the changes to “{name}”?</source>
   <translation>Änderungen an „{name}“ speichern?</translation>
  </message>
  <message>
   <source>Save the design</source>
   <translation>Den Entwurf speichern</translation>
  </message>
  <message>
   <source>Save the design under another name</source>
   <translation>Den Entwurf unter anderem Namen speichern</translation>
  </message>
  <message>
   <source>Save the report</source>
   <translation>Bericht speichern</translation>
  </message>
  <message>
   <source>Save the sheet</source>
   <translation>Datenblatt speichern</translation>
  </message>
  <message>
   <source>Saved</source>
   <translation>Gespeichert</translation>
  </message>
  <message>
   <source>Saved the chart as {written}</source>
   <translation>Diagramm gespeichert als {written}</translation>
  </message>
  <message>
   <source>Saved the data sheet as {path}</source>
   <translation>Datenblatt gespeichert als {path}</translation>
  </message>
  <message>
   <source>Saved the film as {path}</source>
   <translation>Film gespeichert als {path}</translation>
  </message>
  <message>
   <source>Saved the last good design; {count} field(s) with problems are not in {name}</source>
   <translation>Der letzte gute Entwurf ist gespeichert; {count} Feld(er) mit Problemen fehlen in {name}</translation>
  </message>
  <message>
   <source>Saved the nominal grid of the {member} as {path}</source>
   <translation>Sollnetz ({member}) gespeichert als {path}</translation>
  </message>
  <message>
   <source>Saved the picture as {path}</source>
   <translation>Bild gespeichert als {path}</translation>
  </message>
  <message>
   <source>Saved version</source>
   <translation>Gespeicherter Stand</translation>
  </message>
  <message>
   <source>Saved {path}</source>
   <translation>{path} gespeichert</translation>
  </message>
  <message>
   <source>Saved, but no backup could be kept: {reason}</source>
   <translation>Gespeichert, aber keine Sicherung möglich: {reason}</translation>
  </message>
  <message>
   <source>Scale</source>
   <translation>Maßstab</translation>
  </message>
  <message>
   <source>Scale bar</source>
   <translation>Maßstabsbalken</translation>
  </message>
  <message>
   <source>Scale of the combs</source>
   <translation>Maßstab der Kämme</translation>
  </message>
  <message>
   <source>Scale of the deviations: Auto is logarithmic where the curves differ by orders</source>
   <translation>Skala der Abweichungen: Auto ist logarithmisch, wo die Kurven um Größenordnungen auseinanderliegen</translation>
  </message>
  <message>
   <source>Search the parameters by title, symbol or description</source>
   <translation>Die Parameter nach Titel, Zeichen oder Beschreibung durchsuchen</translation>
  </message>
  <message>
   <source>Seconds</source>
   <translation>Sekunden</translation>
  </message>
  <message>
   <source>Section</source>
   <translation>Schnitt</translation>
  </message>
  <message>
   <source>Section of the {member}'s blank</source>
   <translation>Schnitt des Radkörpers: {member}</translation>
  </message>
  <message>
   <source>Sections</source>
   <translation>Schnitte</translation>
  </message>
  <message>
   <source>Select all</source>
   <translation>Alles wählen</translation>
  </message>
  <message>
   <source>Separate the arguments by semicolons, as in max(1,5; 2)</source>
   <translation>Argumente durch Semikolons trennen, wie in max(1,5; 2)</translation>
  </message>
  <message>
   <source>Series of points</source>
   <translation>Punktreihe</translation>
  </message>
  <message>
   <source>Set of layers</source>
   <translation>Satz von Ebenen</translation>
  </message>
  <message>
   <source>Settings</source>
   <translation>Angaben</translation>
  </message>
  <message>
   <source>Shaft angle</source>
   <translation>Achsenwinkel</translation>
  </message>
  <message>
   <source>Shaft angle beyond its nominal value</source>
   <translation>Achsenwinkel über dem Nennwert</translation>
  </message>
  <message>
   <source>Shank diameter</source>
   <translation>Schaftdurchmesser</translation>
  </message>
  <message>
   <source>Shank length</source>
   <translation>Schaftlänge</translation>
  </message>
  <message>
   <source>Share of the flank's depth, from 0 at its lower edge to 1 at the tip; no effect without root relief.</source>
   <translation>Anteil der Flankenhöhe, 0 am unteren Rand, 1 am Kopf; ohne Fußrücknahme wirkungslos.</translation>
  </message>
  <message>
   <source>Share of the flank's depth, from 0 at its lower edge to 1 at the tip; no effect without tip relief.</source>
   <translation>Anteil der Flankenhöhe, 0 am unteren Rand, 1 am Kopf; ohne Kopfrücknahme wirkungslos.</translation>
  </message>
  <message>
   <source>Share of the limit pressure angle that the drive flank gains and the coast flank loses; no effect without an offset.</source>
   <translation>Anteil des Grenzeingriffswinkels, den die Zugflanke gewinnt und die Schubflanke verliert; ohne Achsversatz wirkungslos.</translation>
  </message>
  <message>
   <source>Share of the points</source>
   <translation>Anteil der Punkte</translation>
  </message>
  <message>
   <source>Shared between both members; without a factor of its own c_ham is 0.21 + 0.29/u₉₀², the standard's proposal.</source>
   <translation>Auf beide Räder verteilt; ohne eigenen Faktor ist c_ham gleich 0,21 + 0,29/u₉₀², dem Vorschlag der Norm.</translation>
  </message>
  <message>
   <source>Shift</source>
   <translation>Schub axial</translation>
  </message>
  <message>
   <source>Shifted by</source>
   <translation>Verschoben um</translation>
  </message>
  <message>
   <source>Shifted by the best fit</source>
   <translation>Durch die Einpassung verschoben</translation>
  </message>
  <message>
   <source>Show</source>
   <translation>Zeigen</translation>
  </message>
  <message>
   <source>Show equation</source>
   <translation>Gleichung zeigen</translation>
  </message>
  <message>
   <source>Show everything as in a new window; layers keep their colours</source>
   <translation>Alles wie in einem neuen Fenster zeigen; Ebenen behalten ihre Farben</translation>
  </message>
  <message>
   <source>Show the equation of this row with its numbers (Enter)</source>
   <translation>Die Gleichung dieser Zeile mit ihren Zahlen zeigen (Enter)</translation>
  </message>
  <message>
   <source>Show the pinion and build its flanks</source>
   <translation>Das Ritzel zeigen und seine Flanken bauen</translation>
  </message>
  <message>
   <source>Show the wheel and build its flanks</source>
   <translation>Das Rad zeigen und seine Flanken bauen</translation>
  </message>
  <message>
   <source>Show what else is known</source>
   <translation>Zeigen, was sonst bekannt ist</translation>
  </message>
  <message>
   <source>Show: {words}</source>
   <translation>Zeigt: {words}</translation>
  </message>
  <message>
   <source>Shown and typed in this unit; files stay in mm</source>
   <translation>In dieser Einheit gezeigt und eingegeben; Dateien bleiben in mm</translation>
  </message>
  <message>
   <source>Side of the teeth</source>
   <translation>Zahnseite</translation>
  </message>
  <message>
   <source>Signed extremes: most metal missing, most metal added</source>
   <translation>Extreme mit Vorzeichen: größtes Untermaß, größtes Aufmaß</translation>
  </message>
  <message>
   <source>Signed normal deviation of the solid's flanks from theory</source>
   <translation>Normalabweichung der Flanken des Körpers von der Theorie, mit Vorzeichen</translation>
  </message>
  <message>
   <source>Single and cumulative pitch errors</source>
   <translation>Einzel- und Summenteilungsabweichungen</translation>
  </message>
  <message>
   <source>Size</source>
   <translation>Größe</translation>
  </message>
  <message>
   <source>Size of the film in pixels</source>
   <translation>Größe des Films in Bildpunkten</translation>
  </message>
  <message>
   <source>Sizes of the teeth</source>
   <translation>Maße der Zähne</translation>
  </message>
  <message>
   <source>Smallest principal</source>
   <translation>Kleinste</translation>
  </message>
  <message>
   <source>Smooth</source>
   <translation>Glatt</translation>
  </message>
  <message>
   <source>Snap to corners and middles of edges</source>
   <translation>An Ecken und Kantenmitten fangen</translation>
  </message>
  <message>
   <source>Software, without the graphics card</source>
   <translation>Software, ohne Grafikkarte</translation>
  </message>
  <message>
   <source>Solid</source>
   <translation>Körper</translation>
  </message>
  <message>
   <source>Solids know which faces meet; trimmed surfaces are for programs that know no solids</source>
   <translation>Körper wissen, welche Flächen sich treffen; getrimmte Flächen sind für Programme ohne Körper</translation>
  </message>
  <message>
   <source>Some of the paper's are those of bevel pairs with depths from the module: numbers are put in where an equation holds for this pair.</source>
   <translation>Einige der Veröffentlichung gelten für Kegelradpaare mit Zahnhöhen aus dem Modul: Zahlen sind dort eingesetzt, wo eine Gleichung für dieses Paar gilt.</translation>
  </message>
  <message>
   <source>Something unexpected went wrong. The window goes on, and the design is still there: save it under a new name to be safe. The report below helps to mend the fault; it is also in {path}.</source>
   <translation>Etwas Unerwartetes ging schief. Das Fenster läuft weiter, der Entwurf ist noch da: zur Sicherheit unter neuem Namen speichern. Der Bericht unten hilft, den Fehler zu beheben; er steht auch in {path}.</translation>
  </message>
  <message>
   <source>Source</source>
   <translation>Quelle</translation>
  </message>
  <message>
   <source>Speed</source>
   <translation>Tempo</translation>
  </message>
  <message>
   <source>Speed; at 1× one tooth passes each second</source>
   <translation>Tempo; bei 1× läuft jede Sekunde ein Zahn vorbei</translation>
  </message>
  <message>
   <source>Spheres</source>
   <translation>Kugeln</translation>
  </message>
  <message>
   <source>Spherical involute</source>
   <translation>Kugelevolvente</translation>
  </message>
  <message>
   <source>Spherical involute, 14/39, transverse pressure angle 20°</source>
   <translation>Kugelevolvente, 14/39, Stirneingriffswinkel 20°</translation>
  </message>
  <message>
   <source>Spiral angle</source>
   <translation>Spiralwinkel</translation>
  </message>
  <message>
   <source>Spiral angle at</source>
   <translation>Spiralwinkel bei</translation>
  </message>
  <message>
   <source>Spiral angle at the cone distance R' of a tooth trace that is an arc of the cutter's radius r₀.</source>
   <translation>Spiralwinkel bei der Kegellänge R' einer Flankenlinie, die ein Bogen mit dem Messerkopfradius r₀ ist.</translation>
  </message>
  <message>
   <source>Spiral angle at the toe</source>
   <translation>Spiralwinkel an der Zehe</translation>
  </message>
  <message>
   <source>Spiral angle correction</source>
   <translation>Korrektur des Spiralwinkels</translation>
  </message>
  <message>
   <source>Spiral angle of</source>
   <translation>Spiralwinkel von</translation>
  </message>
  <message>
   <source>Spiral angle, as an angle</source>
   <translation>Spiralwinkel, als Winkel</translation>
  </message>
  <message>
   <source>Spiral angle, heel</source>
   <translation>Spiralwinkel, Ferse</translation>
  </message>
  <message>
   <source>Spiral angle, mean</source>
   <translation>Spiralwinkel, Mitte</translation>
  </message>
  <message>
   <source>Spiral angle, toe</source>
   <translation>Spiralwinkel, Zehe</translation>
  </message>
  <message>
   <source>Spiral angle; 0 gives straight teeth, or zerol teeth with the circular arc.</source>
   <translation>Spiralwinkel; 0 gibt gerade Zähne, mit dem Kreisbogen Zerolzähne.</translation>
  </message>
  <message>
   <source>Spiral angles of both members</source>
   <translation>Spiralwinkel beider Räder</translation>
  </message>
  <message>
   <source>Spiral bevel gear report</source>
   <translation>Bericht über ein Spiralkegelradpaar</translation>
  </message>
  <message>
   <source>Spiral bevel gears from the exact spherical involute: three ways to model the tooth flanks, side by side, and how far each is from theory.</source>
   <translation>Spiralkegelräder aus der exakten Kugelevolvente: drei Wege, die Zahnflanken zu modellieren, nebeneinander, und wie weit jeder von der Theorie abliegt.</translation>
  </message>
  <message>
   <source>Standard</source>
   <translation>Standard</translation>
  </message>
  <message>
   <source>Standard depth with a common apex; with constant clearance the face cone is turned parallel to the mate's root cone instead.</source>
   <translation>Standardhöhe mit gemeinsamer Spitze; bei gleichbleibendem Kopfspiel wird der Kopfkegel parallel zum Fußkegel des Gegenrads gedreht.</translation>
  </message>
  <message>
   <source>Standard: root lines through the pitch apex. Uniform: the same depth from toe to heel. Duplex: constant slot width. Tilted root: constant slot width, but not steeper than 1.3 times standard.</source>
   <translation>Standard: Fußlinien durch die Teilkegelspitze. Gleich hoch: dieselbe Höhe von Zehe bis Ferse. Duplex: gleich weite Lücke. Geneigter Fuß: gleich weite Lücke, aber höchstens 1,3-mal so steil wie Standard.</translation>
  </message>
  <message>
   <source>Standards give the pressure angle in the normal section at the mean point, the paper in the transverse one.</source>
   <translation>Normen geben den Eingriffswinkel im Normalschnitt des Mittelpunkts an, die Arbeit im Stirnschnitt.</translation>
  </message>
  <message>
   <source>Start from the default design</source>
   <translation>Mit dem üblichen Entwurf beginnen</translation>
  </message>
  <message>
   <source>State</source>
   <translation>Zustand</translation>
  </message>
  <message>
   <source>Steel</source>
   <translation>Stahl</translation>
  </message>
  <message>
   <source>Steps</source>
   <translation>Stufen</translation>
  </message>
  <message>
   <source>Stop making the report</source>
   <translation>Bericht nicht weiter erstellen</translation>
  </message>
  <message>
   <source>Stop the work in progress</source>
   <translation>Die laufende Arbeit anhalten</translation>
  </message>
  <message>
   <source>Stop the work in progress (Esc)</source>
   <translation>Die laufende Arbeit anhalten (Esc)</translation>
  </message>
  <message>
   <source>Stopped</source>
   <translation>Angehalten</translation>
  </message>
  <message>
   <source>Straight bevel pair</source>
   <translation>Geradverzahntes Kegelradpaar</translation>
  </message>
  <message>
   <source>Stripes</source>
   <translation>Streifen</translation>
  </message>
  <message>
   <source>Surface or difference</source>
   <translation>Fläche oder Differenz</translation>
  </message>
  <message>
   <source>Surface quality</source>
   <translation>Flächengüte</translation>
  </message>
  <message>
   <source>Symbol</source>
   <translation>Zeichen</translation>
  </message>
  <message>
   <source>Take away the other side</source>
   <translation>Die andere Seite wegnehmen</translation>
  </message>
  <message>
   <source>Take away what lies beyond a plane and show the cut face</source>
   <translation>Wegnehmen, was hinter einer Ebene liegt, und die Schnittfläche zeigen</translation>
  </message>
  <message>
   <source>Take back the last edit</source>
   <translation>Die letzte Änderung zurücknehmen</translation>
  </message>
  <message>
   <source>Take colour and opacity back</source>
   <translation>Farbe und Deckkraft zurücknehmen</translation>
  </message>
  <message>
   <source>Take over</source>
   <translation>Übernehmen</translation>
  </message>
  <message>
   <source>Take the changed file</source>
   <translation>Geänderte Datei übernehmen</translation>
  </message>
  <message>
   <source>Take the marker away (Esc)</source>
   <translation>Die Marke wegnehmen (Esc)</translation>
  </message>
  <message>
   <source>Tangent plane</source>
   <translation>Tangentialebene</translation>
  </message>
  <message>
   <source>Taper</source>
   <translation>Verjüngung</translation>
  </message>
  <message>
   <source>Taper of the wheel</source>
   <translation>Verjüngung am Rad</translation>
  </message>
  <message>
   <source>Teeth</source>
   <translation>Zähne</translation>
  </message>
  <message>
   <source>Teeth as long as the CAD flank is curved</source>
   <translation>Zähne, so lang wie die CAD-Flanke gekrümmt ist</translation>
  </message>
  <message>
   <source>Teeth measured</source>
   <translation>Gemessene Zähne</translation>
  </message>
  <message>
   <source>Text</source>
   <translation>Text</translation>
  </message>
  <message>
   <source>The 3D view could not be loaded.</source>
   <translation>Die 3D-Ansicht konnte nicht geladen werden.</translation>
  </message>
  <message>
   <source>The 3D views are switched off in the preferences (graphics).</source>
   <translation>Die 3D-Ansichten sind in den Einstellungen abgeschaltet (Grafik).</translation>
  </message>
  <message>
   <source>The CAD kernel could not be started. Model ▸ Restart CAD kernel tries again.</source>
   <translation>Der CAD-Kern ließ sich nicht starten. Modell ▸ CAD-Kern neu starten versucht es wieder.</translation>
  </message>
  <message>
   <source>The CAD kernel stopped twice at the same work ({work}), which was given up. It is started again for everything else; change something before you try this again.</source>
   <translation>Der CAD-Kern ist zweimal bei derselben Arbeit abgestürzt ({work}); sie wurde aufgegeben. Für alles andere wird er neu gestartet; ändern Sie etwas, bevor Sie dies noch einmal versuchen.</translation>
  </message>
  <message>
   <source>The CAD kernel stopped unexpectedly ({work}). It is being started again and then tries this once more; nothing of the design is lost.</source>
   <translation>Der CAD-Kern wurde unerwartet beendet ({work}). Er wird neu gestartet und versucht dies dann noch einmal; vom Entwurf ist nichts verloren.</translation>
  </message>
  <message>
   <source>The CAD kernel stopped unexpectedly ({work}). It was started again and has done this now; nothing is lost.</source>
   <translation>Der CAD-Kern wurde unerwartet beendet ({work}). Er wurde neu gestartet und hat dies nun erledigt; nichts ist verloren.</translation>
  </message>
  <message>
   <source>The CAD kernel stopped unexpectedly ({work}). It was started again and tries this once more; nothing of the design is lost.</source>
   <translation>Der CAD-Kern wurde unerwartet beendet ({work}). Er wurde neu gestartet und versucht dies noch einmal; vom Entwurf ist nichts verloren.</translation>
  </message>
  <message>
   <source>The CAD kernel stopped unexpectedly and is being started again; nothing of the design is lost.</source>
   <translation>Der CAD-Kern wurde unerwartet beendet und wird neu gestartet; vom Entwurf ist nichts verloren.</translation>
  </message>
  <message>
   <source>The CAD kernel stopped unexpectedly and was started again; nothing of the design is lost.</source>
   <translation>Der CAD-Kern wurde unerwartet beendet und neu gestartet; vom Entwurf ist nichts verloren.</translation>
  </message>
  <message>
   <source>The CAD process had grown to {size} MB and was started anew; nothing is lost.</source>
   <translation>Der CAD-Prozess war auf {size} MB gewachsen und wurde neu gestartet; nichts ist verloren.</translation>
  </message>
  <message>
   <source>The analysis could not be loaded.</source>
   <translation>Die Auswertung konnte nicht geladen werden.</translation>
  </message>
  <message>
   <source>The axis that viewers take as up is y, as glTF asks; z keeps the gear's own axes</source>
   <translation>Hochachse für Betrachter ist y, wie glTF es verlangt; z behält die Achsen des Rads</translation>
  </message>
  <message>
   <source>The azimuth β is where the point is, the roll angle Θ is how far the plane rolled: not the same angle.</source>
   <translation>Das Azimut β ist, wo der Punkt steht, der Wälzwinkel Θ, wie weit die Ebene rollte: nicht derselbe Winkel.</translation>
  </message>
  <message>
   <source>The basis functions then do not add up to one.</source>
   <translation>Die Basisfunktionen ergeben dann zusammen nicht eins.</translation>
  </message>
  <message>
   <source>The best fit may shift the part along its axis</source>
   <translation>Die Einpassung darf das Teil entlang der Achse schieben</translation>
  </message>
  <message>
   <source>The best fit may turn the part about its axis</source>
   <translation>Die Einpassung darf das Teil um die Achse drehen</translation>
  </message>
  <message>
   <source>The best fit might {ways}.</source>
   <translation>Die Einpassung durfte {ways}.</translation>
  </message>
  <message>
   <source>The chart was not saved: {error}</source>
   <translation>Das Diagramm wurde nicht gespeichert: {error}</translation>
  </message>
  <message>
   <source>The cone on which the generating plane rolls.</source>
   <translation>Der Kegel, auf dem die erzeugende Ebene rollt.</translation>
  </message>
  <message>
   <source>The cone on which the plane rolls</source>
   <translation>Der Kegel, auf dem die Ebene rollt</translation>
  </message>
  <message>
   <source>The cone that rolls on the mate's</source>
   <translation>Der Kegel, der auf dem des Gegenrads rollt</translation>
  </message>
  <message>
   <source>The construction as printed: few positions, two profiles, 7 × 7 points</source>
   <translation>Der Aufbau wie gedruckt: wenige Stellungen, zwei Profile, 7 × 7 Punkte</translation>
  </message>
  <message>
   <source>The construction whose surfaces are written</source>
   <translation>Der Aufbau, dessen Flächen geschrieben werden</translation>
  </message>
  <message>
   <source>The contact could not be analysed; see the notes.</source>
   <translation>Der Zahnkontakt ließ sich nicht untersuchen; siehe die Hinweise.</translation>
  </message>
  <message>
   <source>The cutter's radius is missing below the line.</source>
   <translation>Unter dem Bruchstrich fehlt der Messerkopfradius.</translation>
  </message>
  <message>
   <source>The data sheet was not saved: {error}</source>
   <translation>Das Datenblatt wurde nicht gespeichert: {error}</translation>
  </message>
  <message>
   <source>The design</source>
   <translation>Der Entwurf</translation>
  </message>
  <message>
   <source>The design is not saved, so there is no folder in which exports could be.</source>
   <translation>Der Entwurf ist nicht gespeichert; daher gibt es keinen Ordner, in dem Exporte sein könnten.</translation>
  </message>
  <message>
   <source>The design to compare with</source>
   <translation>Der Entwurf, mit dem verglichen wird</translation>
  </message>
  <message>
   <source>The designs cannot be compared: {reason}</source>
   <translation>Die Entwürfe lassen sich nicht vergleichen: {reason}</translation>
  </message>
  <message>
   <source>The deviations that the paper states of its own gear, for comparison</source>
   <translation>Die Abweichungen, die die Arbeit für ihr eigenes Rad nennt, zum Vergleich</translation>
  </message>
  <message>
   <source>The division by the cosine does not agree with equation (7).</source>
   <translation>Die Teilung durch den Kosinus passt nicht zu Gleichung (7).</translation>
  </message>
  <message>
   <source>The equation</source>
   <translation>Die Gleichung</translation>
  </message>
  <message>
   <source>The equation of the parameter or row with the cursor</source>
   <translation>Die Gleichung des Parameters oder der Zeile mit dem Cursor</translation>
  </message>
  <message>
   <source>The exact flank, translucent</source>
   <translation>Die exakte Flanke, durchscheinend</translation>
  </message>
  <message>
   <source>The export failed: {text}</source>
   <translation>Der Export misslang: {text}</translation>
  </message>
  <message>
   <source>The face cone touches a plane on the wheel's root cone, the root cone one on its face cone, both the clearance away.</source>
   <translation>Der Kopfkegel berührt eine Ebene am Fußkegel des Rads, der Fußkegel eine an dessen Kopfkegel, beide um das Kopfspiel entfernt.</translation>
  </message>
  <message>
   <source>The face width is given as a length: empty that field to use the factor.</source>
   <translation>Die Zahnbreite ist als Länge gegeben: das Feld leeren, um den Faktor zu benutzen.</translation>
  </message>
  <message>
   <source>The flank</source>
   <translation>Die Flanke</translation>
  </message>
  <message>
   <source>The flanks of the three methods in perspective</source>
   <translation>Die Flanken der drei Methoden in Perspektive</translation>
  </message>
  <message>
   <source>The folder of “{name}” is no longer there:
{folder}</source>
   <translation>Den Ordner von „{name}“ gibt es nicht mehr:
{folder}</translation>
  </message>
  <message>
   <source>The formulas used, the paper's departures, and this design's numbers</source>
   <translation>Die benutzten Formeln, Abweichungen von der Arbeit und die Zahlen dieses Entwurfs</translation>
  </message>
  <message>
   <source>The generating line, moved rigidly as the tangent plane rolls on the base cone</source>
   <translation>Die Erzeugende, starr bewegt, während die Tangentialebene auf dem Grundkegel rollt</translation>
  </message>
  <message>
   <source>The generating line, rolled by Θ, lies on the flank to 4·10⁻¹⁴ mm.</source>
   <translation>Die um Θ gerollte Erzeugende liegt auf 4·10⁻¹⁴ mm auf der Flanke.</translation>
  </message>
  <message>
   <source>The inclination of the flank that would slide along the tooth alone: drive and coast flank lie equally far from it.</source>
   <translation>Die Neigung der Flanke, die nur entlang des Zahns gleiten würde: Zug- und Schubflanke liegen gleich weit davon.</translation>
  </message>
  <message>
   <source>The kernel's full check of the solid</source>
   <translation>Die volle Prüfung des Körpers durch den Kern</translation>
  </message>
  <message>
   <source>The language that the report is written in</source>
   <translation>Die Sprache, in der der Bericht geschrieben wird</translation>
  </message>
  <message>
   <source>The last column says where the formula stands: section of the theory, and in brackets the paper's equation.</source>
   <translation>Die letzte Spalte sagt, wo die Formel steht: Abschnitt der Theorie, in Klammern die Gleichung der Veröffentlichung.</translation>
  </message>
  <message>
   <source>The line in the plane, and the flank it has swept</source>
   <translation>Die Gerade in der Ebene und die von ihr überstrichene Flanke</translation>
  </message>
  <message>
   <source>The mate's tip must not roll beyond the start of the flank on the base cone.</source>
   <translation>Der Kopf des Gegenrads darf nicht über den Beginn der Flanke am Grundkegel hinaus wälzen.</translation>
  </message>
  <message>
   <source>The measured points could not be compared with this design; see the notes.</source>
   <translation>Die Messpunkte ließen sich nicht mit diesem Entwurf vergleichen; siehe die Hinweise.</translation>
  </message>
  <message>
   <source>The measurement was cancelled.</source>
   <translation>Die Messung wurde abgebrochen.</translation>
  </message>
  <message>
   <source>The measuring grid with a bar at each point, both flanks</source>
   <translation>Das Messnetz mit einem Balken an jedem Punkt, beide Flanken</translation>
  </message>
  <message>
   <source>The member that is drawn</source>
   <translation>Das gezeichnete Rad</translation>
  </message>
  <message>
   <source>The member, or both where they mesh</source>
   <translation>Das Rad, oder beide im Eingriff</translation>
  </message>
  <message>
   <source>The methods are being built…</source>
   <translation>Die Methoden werden gebaut…</translation>
  </message>
  <message>
   <source>The methods side by side, charts, tooth contact, the data sheet, and measured points.</source>
   <translation>Die Methoden nebeneinander, Diagramme, Zahnkontakt, Datenblatt und Messpunkte.</translation>
  </message>
  <message>
   <source>The modified flank</source>
   <translation>Die modifizierte Flanke</translation>
  </message>
  <message>
   <source>The nominal grid was not saved: {reason}</source>
   <translation>Das Sollnetz wurde nicht gespeichert: {reason}</translation>
  </message>
  <message>
   <source>The offset</source>
   <translation>Der Achsversatz</translation>
  </message>
  <message>
   <source>The opposite flank</source>
   <translation>Die Gegenflanke</translation>
  </message>
  <message>
   <source>The optimised variants refine until they expect to be below it.</source>
   <translation>Die optimierten Varianten verfeinern, bis sie darunter zu liegen erwarten.</translation>
  </message>
  <message>
   <source>The other flank of the tooth is the mirror image about the tooth's middle.</source>
   <translation>Die andere Flanke des Zahns ist das Spiegelbild an der Zahnmitte.</translation>
  </message>
  <message>
   <source>The other teeth and the body, in light grey</source>
   <translation>Die anderen Zähne und der Körper, in Hellgrau</translation>
  </message>
  <message>
   <source>The pair</source>
   <translation>Das Paar</translation>
  </message>
  <message>
   <source>The pair in mesh</source>
   <translation>Das Paar im Eingriff</translation>
  </message>
  <message>
   <source>The paper prints</source>
   <translation>Die Arbeit druckt</translation>
  </message>
  <message>
   <source>The paper turns the flank.</source>
   <translation>Die Arbeit dreht die Flanke.</translation>
  </message>
  <message>
   <source>The paper: mean deviation of its three methods; the data of its gear are not printed</source>
   <translation>Die Arbeit: mittlere Abweichung ihrer drei Methoden; die Daten ihres Rads sind nicht gedruckt</translation>
  </message>
  <message>
   <source>The parameters that differ, as they were saved and as they were recovered</source>
   <translation>Die abweichenden Parameter, wie sie gespeichert und wie sie wiederhergestellt wurden</translation>
  </message>
  <message>
   <source>The picture is on the clipboard</source>
   <translation>Das Bild ist in der Zwischenablage</translation>
  </message>
  <message>
   <source>The pinion's concave flank leads</source>
   <translation>Die konkave Flanke des Ritzels führt</translation>
  </message>
  <message>
   <source>The pinion's conjugate flank</source>
   <translation>Die konjugierte Flanke des Ritzels</translation>
  </message>
  <message>
   <source>The pinion's convex flank leads</source>
   <translation>Die konvexe Flanke des Ritzels führt</translation>
  </message>
  <message>
   <source>The pinion's flanks as the wheel makes them</source>
   <translation>Ritzelflanken, wie das Rad sie erzeugt</translation>
  </message>
  <message>
   <source>The pitch angles are those for which it is the radius of the wheel's tooth trace: r₀ for a cutter's arc.</source>
   <translation>Die Teilkegelwinkel sind die, bei denen er der Radius der Flankenlinie des Rads ist: r₀ beim Messerkopfbogen.</translation>
  </message>
  <message>
   <source>The pitch cones of two gears with crossing axes roll on each other; z' are the mate's teeth. For a right angle it is the paper's arctan z / z'.</source>
   <translation>Die Teilkegel zweier Räder mit sich schneidenden Achsen rollen aufeinander; z' sind die Zähne des Gegenrads. Beim rechten Winkel ist es arctan z / z' der Arbeit.</translation>
  </message>
  <message>
   <source>The point of the flank under the pointer</source>
   <translation>Der Punkt der Flanke unter dem Zeiger</translation>
  </message>
  <message>
   <source>The printed bound does not return the spiral angle it is made from.</source>
   <translation>Die gedruckte Grenze gibt den Spiralwinkel, aus dem sie gemacht ist, nicht zurück.</translation>
  </message>
  <message>
   <source>The printed form is a length, not a number; the used one meets tan β = ρ ψ′(ρ) to 10⁻⁸.</source>
   <translation>Die gedruckte Form ist eine Länge, keine Zahl; die benutzte erfüllt tan β = ρ ψ′(ρ) auf 10⁻⁸.</translation>
  </message>
  <message>
   <source>The printed form is a ratio of lengths, not a count.</source>
   <translation>Die gedruckte Form ist ein Längenverhältnis, keine Anzahl.</translation>
  </message>
  <message>
   <source>The process that builds flanks and solids</source>
   <translation>Der Prozess, der Flanken und Körper baut</translation>
  </message>
  <message>
   <source>The publication does not print the data from which it could be computed</source>
   <translation>Die Veröffentlichung druckt die Daten zur Berechnung nicht</translation>
  </message>
  <message>
   <source>The report could not be made: the CAD kernel stopped. {reason}</source>
   <translation>Bericht nicht erstellt: der CAD-Kern wurde angehalten. {reason}</translation>
  </message>
  <message>
   <source>The report could not be made: {reason}</source>
   <translation>Der Bericht konnte nicht erstellt werden: {reason}</translation>
  </message>
  <message>
   <source>The rolling plane's point</source>
   <translation>Der Punkt der rollenden Ebene</translation>
  </message>
  <message>
   <source>The settings are reset; some take effect when GearStudio starts again.</source>
   <translation>Die Einstellungen sind zurückgesetzt; einige gelten ab dem nächsten Start.</translation>
  </message>
  <message>
   <source>The settings file was damaged, so the window starts with the usual settings. {where}</source>
   <translation>Die Einstellungsdatei war beschädigt; das Fenster beginnt mit den üblichen Einstellungen. {where}</translation>
  </message>
  <message>
   <source>The shortest distance between the axes, from the mean point's radii; a_p is the part in the pitch plane.</source>
   <translation>Der kürzeste Abstand der Achsen, aus den Radien des Mittelpunkts; a_p ist der Anteil in der Teilebene.</translation>
  </message>
  <message>
   <source>The standard taper: root lines through the pitch apex. With uniform depth both angles are 0; duplex and tilted root divide another sum of the dedendum angles as the depth is divided; an angle that is given wins.</source>
   <translation>Die Standardverjüngung: Fußlinien durch die Teilkegelspitze. Bei gleich hohen Zähnen sind beide Winkel 0; Duplex und geneigter Fuß teilen eine andere Summe der Fußwinkel so, wie die Zahnhöhe geteilt ist; ein angegebener Winkel geht vor.</translation>
  </message>
  <message>
   <source>The step before</source>
   <translation>Der Schritt davor</translation>
  </message>
  <message>
   <source>The sum divides by zero</source>
   <translation>Die Rechnung teilt durch null</translation>
  </message>
  <message>
   <source>The sum has no finite value</source>
   <translation>Die Rechnung hat keinen endlichen Wert</translation>
  </message>
  <message>
   <source>The sum has no value: look at the arguments of its functions</source>
   <translation>Die Rechnung hat keinen Wert: die Argumente ihrer Funktionen prüfen</translation>
  </message>
  <message>
   <source>The sum is longer than {count} characters</source>
   <translation>Die Rechnung ist länger als {count} Zeichen</translation>
  </message>
  <message>
   <source>The sum of the dedendum angles for which both slots keep their width along the face; κ is the tooth trace's curvature. A tilted root line takes at most 1.3 times the standard sum.</source>
   <translation>Die Summe der Fußwinkel, bei der beide Lücken ihre Weite entlang der Breite behalten; κ ist die Krümmung der Flankenlinie. Eine geneigte Fußlinie nimmt höchstens das 1,3-Fache der Standardsumme.</translation>
  </message>
  <message>
   <source>The system refused to start another window.</source>
   <translation>Das System ließ kein weiteres Fenster zu.</translation>
  </message>
  <message>
   <source>The teeth end square to the pitch cone: ρ_u is the cone distance there, and points above and below are farther from the apex.</source>
   <translation>Die Zähne enden rechtwinklig zum Teilkegel: ρ_u ist die Kegellänge dort, und Punkte darüber und darunter sind weiter von der Spitze entfernt.</translation>
  </message>
  <message>
   <source>The teeth run along each other at the mean point, the cones' elements do not.</source>
   <translation>Im Mittelpunkt laufen die Zähne aneinander entlang, die Mantellinien der Kegel nicht.</translation>
  </message>
  <message>
   <source>The theoretical surface, explicit in azimuth: the deviation of any point from it needs no search.</source>
   <translation>Die theoretische Fläche, explizit im Azimut: die Abweichung jedes Punkts braucht keine Suche.</translation>
  </message>
  <message>
   <source>The thickness factor makes the pinion's teeth thicker and the wheel's thinner; x_sm has the backlash's share.</source>
   <translation>Der Zahndickenfaktor macht die Zähne des Ritzels dicker und die des Rads dünner; x_sm enthält den Anteil des Flankenspiels.</translation>
  </message>
  <message>
   <source>The three methods side by side, seen from the same place</source>
   <translation>Die drei Methoden nebeneinander, vom selben Ort gesehen</translation>
  </message>
  <message>
   <source>The tips run parallel to the mate's root cone, through the tip's corner at the heel; the face cone has an apex of its own.</source>
   <translation>Die Köpfe laufen parallel zum Fußkegel des Gegenrads, durch die Kopfkante an der Ferse; der Kopfkegel hat eine eigene Spitze.</translation>
  </message>
  <message>
   <source>The tooth is self-similar: every section is the heel's, scaled by ρ and turned by θ(ρ).</source>
   <translation>Der Zahn ist selbstähnlich: jeder Schnitt ist der an der Ferse, mit ρ skaliert und um θ(ρ) gedreht.</translation>
  </message>
  <message>
   <source>The tooth profile, swept from heel to toe along the tooth trace</source>
   <translation>Das Zahnprofil, von Ferse zu Zehe entlang der Flankenlinie geführt</translation>
  </message>
  <message>
   <source>The tooth that is drawn</source>
   <translation>Der Zahn, der gezeichnet wird</translation>
  </message>
  <message>
   <source>The turn of the wheel over its pitch: while contact moves over the profile in the middle of the face (ε_α), along the face at half the depth (ε_β), and over the whole flank (ε_γ).</source>
   <translation>Die Drehung des Rads durch seine Teilung: während die Berührung über das Profil in der Mitte der Breite wandert (ε_α), entlang der Breite in halber Höhe (ε_β), und über die ganze Flanke (ε_γ).</translation>
  </message>
  <message>
   <source>The turn θ(ρ) is missing.</source>
   <translation>Die Drehung θ(ρ) fehlt.</translation>
  </message>
  <message>
   <source>The views</source>
   <translation>Die Ansichten</translation>
  </message>
  <message>
   <source>The weights are missing above the line.</source>
   <translation>Über dem Bruchstrich fehlen die Gewichte.</translation>
  </message>
  <message>
   <source>The wheel's mean addendum over working depth; leave empty for 0.21 + 0.29/u₉₀².</source>
   <translation>Mittlere Kopfhöhe des Rads durch gemeinsame Zahnhöhe; leer: 0,21 + 0,29/u₉₀².</translation>
  </message>
  <message>
   <source>The whole window</source>
   <translation>Das ganze Fenster</translation>
  </message>
  <message>
   <source>The window alone on the screen, and back</source>
   <translation>Das Fenster allein auf dem Schirm, und zurück</translation>
  </message>
  <message>
   <source>The window changes its language at once; the design and its results stay as they are.</source>
   <translation>Das Fenster wechselt die Sprache sofort; Entwurf und Ergebnisse bleiben, wie sie sind.</translation>
  </message>
  <message>
   <source>The words of the field, as they are used here</source>
   <translation>Die Wörter des Fachs, wie sie hier gebraucht werden</translation>
  </message>
  <message>
   <source>The {flank} flank</source>
   <translation>Die Flanke: {flank}</translation>
  </message>
  <message>
   <source>Theme</source>
   <translation>Farbschema</translation>
  </message>
  <message>
   <source>Theoretical flank</source>
   <translation>Theoretische Flanke</translation>
  </message>
  <message>
   <source>Theory</source>
   <translation>Theorie</translation>
  </message>
  <message>
   <source>Theory, section {section}</source>
   <translation>Theorie, Abschnitt {section}</translation>
  </message>
  <message>
   <source>There are no backups yet; each save of a design makes one.</source>
   <translation>Noch keine Sicherungen; jedes Speichern eines Entwurfs legt eine an.</translation>
  </message>
  <message>
   <source>There are no exports with a record in {folder}.</source>
   <translation>In {folder} gibt es keine Exporte mit Prüfbericht.</translation>
  </message>
  <message>
   <source>There is no unsaved work to recover.</source>
   <translation>Es gibt keine ungesicherte Arbeit wiederherzustellen.</translation>
  </message>
  <message>
   <source>There is no {field} to begin or end.</source>
   <translation>Ohne {field} gibt es keinen Beginn und kein Ende.</translation>
  </message>
  <message>
   <source>There was no best fit.</source>
   <translation>Es wurde nicht eingepasst.</translation>
  </message>
  <message>
   <source>These are the values of an earlier design; of this one there are none: {error}</source>
   <translation>Dies sind Werte eines früheren Entwurfs; von diesem gibt es keine: {error}</translation>
  </message>
  <message>
   <source>These panels share a place while the window is narrow</source>
   <translation>Diese Felder teilen sich einen Platz, solange das Fenster schmal ist</translation>
  </message>
  <message>
   <source>These sizes make no blank; the field says why.</source>
   <translation>Diese Maße ergeben keinen Radkörper; das Feld sagt, warum.</translation>
  </message>
  <message>
   <source>They are lost if you do not save them.</source>
   <translation>Ohne Speichern gehen sie verloren.</translation>
  </message>
  <message>
   <source>Thickness</source>
   <translation>Zahndicke</translation>
  </message>
  <message>
   <source>Thickness and chord</source>
   <translation>Zahndicke und Sehne</translation>
  </message>
  <message>
   <source>Thickness factor</source>
   <translation>Zahndickenfaktor</translation>
  </message>
  <message>
   <source>Thickness modification coefficient</source>
   <translation>Zahndickenbeiwert</translation>
  </message>
  <message>
   <source>Thickness of the marking compound: where the gap is less, it is wiped off</source>
   <translation>Dicke der Tuschierpaste: wo der Spalt kleiner ist, wird sie abgewischt</translation>
  </message>
  <message>
   <source>Thickness of the tip; where it is not positive the tooth is pointed.</source>
   <translation>Dicke des Kopfs; wo sie nicht positiv ist, ist der Zahn spitz.</translation>
  </message>
  <message>
   <source>Thickness that the pinion's teeth gain over the wheel's, over mean normal module.</source>
   <translation>Dicke, die die Ritzelzähne gegenüber dem Rad gewinnen, durch mittleren Normalmodul.</translation>
  </message>
  <message>
   <source>This design</source>
   <translation>Dieser Entwurf</translation>
  </message>
  <message>
   <source>This design has no complete tooth; see the notes.</source>
   <translation>Dieser Entwurf hat keinen vollständigen Zahn; siehe die Hinweise.</translation>
  </message>
  <message>
   <source>This design was never saved.</source>
   <translation>Dieser Entwurf wurde nie gespeichert.</translation>
  </message>
  <message>
   <source>This display offers no OpenGL.</source>
   <translation>Diese Anzeige bietet kein OpenGL.</translation>
  </message>
  <message>
   <source>This parameter enters no equation.</source>
   <translation>Dieser Parameter geht in keine Gleichung ein.</translation>
  </message>
  <message>
   <source>This solid</source>
   <translation>Dieser Körper</translation>
  </message>
  <message>
   <source>Three methods, two variants</source>
   <translation>Drei Methoden, zwei Varianten</translation>
  </message>
  <message>
   <source>Tick a format to see how it can be written.</source>
   <translation>Ein Format ankreuzen, um seine Möglichkeiten zu sehen.</translation>
  </message>
  <message>
   <source>Tilted root</source>
   <translation>Geneigter Fuß</translation>
  </message>
  <message>
   <source>Time</source>
   <translation>Zeit</translation>
  </message>
  <message>
   <source>Time [ms]</source>
   <translation>Zeit [ms]</translation>
  </message>
  <message>
   <source>Time to build both flanks</source>
   <translation>Zeit für beide Flanken</translation>
  </message>
  <message>
   <source>Tip and root</source>
   <translation>Kopf und Fuß</translation>
  </message>
  <message>
   <source>Tip clearance at the heel over outer module.</source>
   <translation>Kopfspiel an der Ferse durch Außenmodul.</translation>
  </message>
  <message>
   <source>Tip clearance over working depth.</source>
   <translation>Kopfspiel durch gemeinsame Zahnhöhe.</translation>
  </message>
  <message>
   <source>Tip cone</source>
   <translation>Kopfkegel</translation>
  </message>
  <message>
   <source>Tip land</source>
   <translation>Zahnkopfdicke</translation>
  </message>
  <message>
   <source>Tip land, heel</source>
   <translation>Zahnkopfdicke, Ferse</translation>
  </message>
  <message>
   <source>Tip land, toe</source>
   <translation>Zahnkopfdicke, Zehe</translation>
  </message>
  <message>
   <source>Tip relief</source>
   <translation>Kopfrücknahme</translation>
  </message>
  <message>
   <source>Tip relief starts at</source>
   <translation>Kopfrücknahme beginnt bei</translation>
  </message>
  <message>
   <source>Tip, fillets, root and ends of the tooth, in light grey</source>
   <translation>Kopf, Fußrundungen, Fuß und Enden des Zahns, in Hellgrau</translation>
  </message>
  <message>
   <source>Titles, axes and scale bar</source>
   <translation>Titel, Achsen und Maßstabsbalken</translation>
  </message>
  <message>
   <source>To [{unit}]</source>
   <translation>Bis [{unit}]</translation>
  </message>
  <message>
   <source>To draw without a graphics card, start GearStudio with: --graphics software</source>
   <translation>Zum Zeichnen ohne Grafikkarte GearStudio so starten: --graphics software</translation>
  </message>
  <message>
   <source>Toe – heel</source>
   <translation>Zehe – Ferse</translation>
  </message>
  <message>
   <source>Toe, base cone</source>
   <translation>Zehe, Grundkegel</translation>
  </message>
  <message>
   <source>Tolerance</source>
   <translation>Toleranz</translation>
  </message>
  <message>
   <source>Tooth</source>
   <translation>Zahn</translation>
  </message>
  <message>
   <source>Tooth contact</source>
   <translation>Zahnkontakt</translation>
  </message>
  <message>
   <source>Tooth ends</source>
   <translation>Zahnenden</translation>
  </message>
  <message>
   <source>Tooth form</source>
   <translation>Zahnform</translation>
  </message>
  <message>
   <source>Tooth profile</source>
   <translation>Zahnprofil</translation>
  </message>
  <message>
   <source>Tooth trace of a cutter</source>
   <translation>Flankenlinie eines Messerkopfs</translation>
  </message>
  <message>
   <source>Tooth {number}</source>
   <translation>Zahn {number}</translation>
  </message>
  <message>
   <source>Topography</source>
   <translation>Topografie</translation>
  </message>
  <message>
   <source>Total contact ratio</source>
   <translation>Gesamtüberdeckung</translation>
  </message>
  <message>
   <source>Tour</source>
   <translation>Rundgang</translation>
  </message>
  <message>
   <source>Transmission error</source>
   <translation>Drehwegabweichung</translation>
  </message>
  <message>
   <source>Transmission error over three pitches.</source>
   <translation>Drehwegabweichung über drei Teilungen.</translation>
  </message>
  <message>
   <source>Transmission error, peak to peak [″]</source>
   <translation>Drehwegabweichung, Spitze zu Spitze [″]</translation>
  </message>
  <message>
   <source>Transparent background</source>
   <translation>Durchsichtiger Hintergrund</translation>
  </message>
  <message>
   <source>Transverse</source>
   <translation>Stirnschnitt</translation>
  </message>
  <message>
   <source>Transverse backlash at the heel pitch circle, half from each member.</source>
   <translation>Verdrehflankenspiel am Teilkreis der Ferse, halb von jedem Rad.</translation>
  </message>
  <message>
   <source>Transverse backlash, outer</source>
   <translation>Verdrehflankenspiel, außen</translation>
  </message>
  <message>
   <source>Transverse chordal thickness, outer</source>
   <translation>Zahndickensehne im Stirnschnitt, außen</translation>
  </message>
  <message>
   <source>Transverse circular thickness, mean</source>
   <translation>Zahndicke im Stirnschnitt, Mitte</translation>
  </message>
  <message>
   <source>Transverse circular thickness, outer</source>
   <translation>Zahndicke im Stirnschnitt, außen</translation>
  </message>
  <message>
   <source>Transverse contact ratio</source>
   <translation>Profilüberdeckung</translation>
  </message>
  <message>
   <source>Transverse contact ratio on the heel sphere, and overlap ratio.</source>
   <translation>Profilüberdeckung auf der Fersenkugel, und Sprungüberdeckung.</translation>
  </message>
  <message>
   <source>Transverse pressure angle</source>
   <translation>Stirneingriffswinkel</translation>
  </message>
  <message>
   <source>Triangles within</source>
   <translation>Dreiecke innerhalb</translation>
  </message>
  <message>
   <source>Turn</source>
   <translation>Drehung</translation>
  </message>
  <message>
   <source>Turn of the pinion</source>
   <translation>Drehung des Ritzels</translation>
  </message>
  <message>
   <source>Turn of the spiral from toe to heel</source>
   <translation>Drehung der Spirale von Zehe zu Ferse</translation>
  </message>
  <message>
   <source>Turn the pair in mesh</source>
   <translation>Das Paar im Eingriff drehen</translation>
  </message>
  <message>
   <source>Turn the views together, or each by itself</source>
   <translation>Die Ansichten gemeinsam drehen, oder jede für sich</translation>
  </message>
  <message>
   <source>Turned by</source>
   <translation>Gedreht um</translation>
  </message>
  <message>
   <source>Turned by the best fit</source>
   <translation>Durch die Einpassung gedreht</translation>
  </message>
  <message>
   <source>Turns the lamps</source>
   <translation>Dreht die Lampen</translation>
  </message>
  <message>
   <source>Turntable</source>
   <translation>Drehteller</translation>
  </message>
  <message>
   <source>Two equal gears at 90° with the Archimedean spiral, the spiral angle given at the toe as in the paper</source>
   <translation>Zwei gleiche Räder bei 90° mit archimedischer Spirale, Spiralwinkel an der Zehe wie in der Arbeit</translation>
  </message>
  <message>
   <source>Type a command or a parameter</source>
   <translation>Befehl oder Parameter eingeben</translation>
  </message>
  <message>
   <source>Type the range…</source>
   <translation>Bereich eingeben…</translation>
  </message>
  <message>
   <source>Undercut margin</source>
   <translation>Reserve gegen Unterschnitt</translation>
  </message>
  <message>
   <source>Undercut margin: rolled arc left below the mate's tip</source>
   <translation>Unterschnittreserve: Wälzbogen unter dem Kopf des Gegenrads</translation>
  </message>
  <message>
   <source>Undercut of the pinion</source>
   <translation>Unterschnitt am Ritzel</translation>
  </message>
  <message>
   <source>Undone: {step}</source>
   <translation>Zurückgenommen: {step}</translation>
  </message>
  <message>
   <source>Unexpected error</source>
   <translation>Unerwarteter Fehler</translation>
  </message>
  <message>
   <source>Unfold all groups</source>
   <translation>Alle Gruppen aufklappen</translation>
  </message>
  <message>
   <source>Uniform</source>
   <translation>Gleich hoch</translation>
  </message>
  <message>
   <source>Unit</source>
   <translation>Einheit</translation>
  </message>
  <message>
   <source>Unit of deviations on the colour scale and in the views</source>
   <translation>Einheit der Abweichungen auf der Farbskala und in den Ansichten</translation>
  </message>
  <message>
   <source>Unit of length in the file; the gear keeps its size</source>
   <translation>Längeneinheit der Datei; das Rad behält seine Größe</translation>
  </message>
  <message>
   <source>Units, colours and language</source>
   <translation>Einheiten, Farben und Sprache</translation>
  </message>
  <message>
   <source>Units, theme, language, memory and keys</source>
   <translation>Einheiten, Farbschema, Sprache, Speicher und Tasten</translation>
  </message>
  <message>
   <source>Unnamed pair</source>
   <translation>Paar ohne Namen</translation>
  </message>
  <message>
   <source>Unsaved changes</source>
   <translation>Ungesicherte Änderungen</translation>
  </message>
  <message>
   <source>Unsaved edits cannot be kept for recovery: {reason}</source>
   <translation>Ungesicherte Änderungen können nicht bewahrt werden: {reason}</translation>
  </message>
  <message>
   <source>Untitled</source>
   <translation>Ohne Titel</translation>
  </message>
  <message>
   <source>Up to date</source>
   <translation>Aktuell</translation>
  </message>
  <message>
   <source>Up to ± [{unit}]</source>
   <translation>Bis ± [{unit}]</translation>
  </message>
  <message>
   <source>Upper end of the scale</source>
   <translation>Oberes Ende der Skala</translation>
  </message>
  <message>
   <source>Used by: {parameters}</source>
   <translation>Benutzt von: {parameters}</translation>
  </message>
  <message>
   <source>Usual</source>
   <translation>Üblich</translation>
  </message>
  <message>
   <source>Valid</source>
   <translation>Gültig</translation>
  </message>
  <message>
   <source>Value</source>
   <translation>Wert</translation>
  </message>
  <message>
   <source>Values at the picked point</source>
   <translation>Werte am gewählten Punkt</translation>
  </message>
  <message>
   <source>Values with a unit can be added, but not multiplied with each other</source>
   <translation>Werte mit Einheit können addiert, aber nicht multipliziert werden</translation>
  </message>
  <message>
   <source>Variant</source>
   <translation>Variante</translation>
  </message>
  <message>
   <source>Verdict</source>
   <translation>Urteil</translation>
  </message>
  <message>
   <source>Views</source>
   <translation>Ansichten</translation>
  </message>
  <message>
   <source>Virtual normal diameter, mean</source>
   <translation>Normaler Ersatzdurchmesser, Mitte</translation>
  </message>
  <message>
   <source>Volume</source>
   <translation>Volumen</translation>
  </message>
  <message>
   <source>Volume, mass and moments of the solids that are built</source>
   <translation>Volumen, Masse und Momente der gebauten Körper</translation>
  </message>
  <message>
   <source>Warning</source>
   <translation>Warnung</translation>
  </message>
  <message>
   <source>Warning: {message}.</source>
   <translation>Warnung: {message}.</translation>
  </message>
  <message>
   <source>Warnings and errors</source>
   <translation>Warnungen und Fehler</translation>
  </message>
  <message>
   <source>Web thickness</source>
   <translation>Stegdicke</translation>
  </message>
  <message>
   <source>Weights above and below the line.</source>
   <translation>Gewichte über und unter dem Bruchstrich.</translation>
  </message>
  <message>
   <source>What colours the CAD flanks</source>
   <translation>Wonach die CAD-Flanken gefärbt sind</translation>
  </message>
  <message>
   <source>What draws the 3D views</source>
   <translation>Womit die 3D-Ansichten gezeichnet werden</translation>
  </message>
  <message>
   <source>What else is known</source>
   <translation>Was sonst bekannt ist</translation>
  </message>
  <message>
   <source>What follows from the parameters</source>
   <translation>Was aus den Parametern folgt</translation>
  </message>
  <message>
   <source>What is drawn: deviation, exact flank, sections and points, and how the flank comes about.</source>
   <translation>Was gezeichnet wird: Abweichung, exakte Flanke, Schnitte und Punkte, und wie die Flanke entsteht.</translation>
  </message>
  <message>
   <source>What is in the picture</source>
   <translation>Was auf dem Bild ist</translation>
  </message>
  <message>
   <source>What is this?</source>
   <translation>Was ist das?</translation>
  </message>
  <message>
   <source>What is written over the views</source>
   <translation>Was über den Ansichten steht</translation>
  </message>
  <message>
   <source>What is wrong with the parameters</source>
   <translation>Was an den Parametern falsch ist</translation>
  </message>
  <message>
   <source>What moves in the film</source>
   <translation>Was sich im Film bewegt</translation>
  </message>
  <message>
   <source>What of it</source>
   <translation>Was davon</translation>
  </message>
  <message>
   <source>What others printed, computed again</source>
   <translation>Was andere druckten, neu berechnet</translation>
  </message>
  <message>
   <source>What the construction took</source>
   <translation>Was der Aufbau brauchte</translation>
  </message>
  <message>
   <source>What the contact is computed for, and its numbers</source>
   <translation>Wofür der Kontakt berechnet wird, und seine Zahlen</translation>
  </message>
  <message>
   <source>What the lamps are fixed to</source>
   <translation>Woran die Lampen befestigt sind</translation>
  </message>
  <message>
   <source>What the program noted, the newest last</source>
   <translation>Was das Programm vermerkte, das Neueste zuletzt</translation>
  </message>
  <message>
   <source>What this design is called.</source>
   <translation>Wie dieser Entwurf heißt.</translation>
  </message>
  <message>
   <source>What this is, and the versions of its parts</source>
   <translation>Was dies ist, und die Versionen seiner Teile</translation>
  </message>
  <message>
   <source>What was made and what was found, for “gearstudio verify”</source>
   <translation>Was gemacht und was gefunden wurde, für „gearstudio verify“</translation>
  </message>
  <message>
   <source>What was written beside the project, and what was found on reading it back</source>
   <translation>Was neben das Projekt geschrieben und beim Zurücklesen gefunden wurde</translation>
  </message>
  <message>
   <source>Wheel</source>
   <translation>Rad</translation>
  </message>
  <message>
   <source>Wheel along its axis, positive away from the crossing point</source>
   <translation>Rad entlang seiner Achse, positiv vom Achsschnittpunkt weg</translation>
  </message>
  <message>
   <source>Wheel axis along +z; the flanks are exactly conjugate.</source>
   <translation>Radachse entlang +z; die Flanken sind exakt konjugiert.</translation>
  </message>
  <message>
   <source>Wheel blank</source>
   <translation>Radkörper Rad</translation>
  </message>
  <message>
   <source>Wheel teeth</source>
   <translation>Zähne Rad</translation>
  </message>
  <message>
   <source>Where each method deviates from the exact flank</source>
   <translation>Wo jede Methode von der exakten Flanke abweicht</translation>
  </message>
  <message>
   <source>Where the files are written</source>
   <translation>Wohin die Dateien geschrieben werden</translation>
  </message>
  <message>
   <source>Where the involutes start on the base cone</source>
   <translation>Wo die Evolventen auf dem Grundkegel beginnen</translation>
  </message>
  <message>
   <source>Where the involutes start; the generating line is this curve unrolled into the tangent plane.</source>
   <translation>Wo die Evolventen beginnen; die Erzeugende ist diese Kurve, in die Tangentialebene abgewickelt.</translation>
  </message>
  <message>
   <source>Where the marking compound is wiped off</source>
   <translation>Wo die Tuschierpaste abgewischt ist</translation>
  </message>
  <message>
   <source>Where the plane of the section stands</source>
   <translation>Wo die Schnittebene steht</translation>
  </message>
  <message>
   <source>Where things are in the window, step by step</source>
   <translation>Wo was im Fenster ist, Schritt für Schritt</translation>
  </message>
  <message>
   <source>Which entries are shown</source>
   <translation>Welche Einträge gezeigt werden</translation>
  </message>
  <message>
   <source>Which method and which variant is shown: as the paper has it, or refined until it meets the tolerance.</source>
   <translation>Welche Methode und Variante gezeigt wird: wie in der Arbeit, oder verfeinert bis zur Toleranz.</translation>
  </message>
  <message>
   <source>White</source>
   <translation>Weiß</translation>
  </message>
  <message>
   <source>Whole gear</source>
   <translation>Ganzes Rad</translation>
  </message>
  <message>
   <source>With an offset the pressure angle is the normal one.</source>
   <translation>Mit Achsversatz gilt der Normaleingriffswinkel.</translation>
  </message>
  <message>
   <source>With an offset the spiral angle is given at the mean point.</source>
   <translation>Mit Achsversatz gilt der Spiralwinkel im Mittelpunkt.</translation>
  </message>
  <message>
   <source>With an offset the tips run parallel to the mate's root: no apex is common.</source>
   <translation>Mit Achsversatz läuft der Kopf parallel zum Fuß des Gegenrads: es gibt keine gemeinsame Spitze.</translation>
  </message>
  <message>
   <source>With the camera</source>
   <translation>Mit der Kamera</translation>
  </message>
  <message>
   <source>With the gear</source>
   <translation>Mit dem Rad</translation>
  </message>
  <message>
   <source>With the printed form equation (7) gives R = 222.2 mm instead of 86.9 mm (17/40 teeth, m = 4 mm, transverse 20°, wheel).</source>
   <translation>Mit der gedruckten Form gibt Gleichung (7) R = 222,2 mm statt 86,9 mm (17/40 Zähne, m = 4 mm, Stirn 20°, Rad).</translation>
  </message>
  <message>
   <source>With {value} no derived value would change.</source>
   <translation>Mit {value} würde sich kein abgeleiteter Wert ändern.</translation>
  </message>
  <message>
   <source>With {value}:</source>
   <translation>Mit {value}:</translation>
  </message>
  <message>
   <source>Within {value}: {efforts}</source>
   <translation>Innerhalb {value}: {efforts}</translation>
  </message>
  <message>
   <source>Without it the guide leaves the flank of a spiral tooth.</source>
   <translation>Ohne sie verlässt die Führung die Flanke eines Spiralzahns.</translation>
  </message>
  <message>
   <source>Without misalignment, marking compound {thickness} µm thick; the least backlash while rolling is {play} mm. Drive: the pinion's concave flank leads. The centre of the pattern is given as a part of the face from the toe and of the profile from the root.</source>
   <translation>Ohne Einbaufehler, Tuschierpaste {thickness} µm dick; das kleinste Flankenspiel beim Abwälzen ist {play} mm. Zug: die konkave Flanke des Ritzels führt. Die Mitte des Tragbilds ist als Teil der Breite von der Zehe und des Profils vom Fuß angegeben.</translation>
  </message>
  <message>
   <source>Words of the title or the text, or the paper's number</source>
   <translation>Wörter aus Titel oder Text, oder die Nummer der Arbeit</translation>
  </message>
  <message>
   <source>Words of the window</source>
   <translation>Wörter des Fensters</translation>
  </message>
  <message>
   <source>Words of title, symbol, description or group</source>
   <translation>Wörter aus Titel, Zeichen, Beschreibung oder Gruppe</translation>
  </message>
  <message>
   <source>Work</source>
   <translation>Arbeit</translation>
  </message>
  <message>
   <source>Working depth and clearance</source>
   <translation>Gemeinsame Zahnhöhe und Kopfspiel</translation>
  </message>
  <message>
   <source>Working depth at the mean point over mean normal module.</source>
   <translation>Gemeinsame Zahnhöhe im Mittelpunkt durch mittleren Normalmodul.</translation>
  </message>
  <message>
   <source>Working flanks</source>
   <translation>Arbeitsflanken</translation>
  </message>
  <message>
   <source>Write flanks, teeth, gears or the pair for other programs</source>
   <translation>Flanken, Zähne, Räder oder das Paar für andere Programme schreiben</translation>
  </message>
  <message>
   <source>Write the files and check them</source>
   <translation>Die Dateien schreiben und prüfen</translation>
  </message>
  <message>
   <source>Write the nominal points with normals, for a coordinate measuring machine</source>
   <translation>Die Sollpunkte mit Normalen schreiben, für ein Koordinatenmessgerät</translation>
  </message>
  <message>
   <source>Writes {names}</source>
   <translation>Schreibt {names}</translation>
  </message>
  <message>
   <source>Written</source>
   <translation>Geschrieben</translation>
  </message>
  <message>
   <source>Wrote {names} to {folder}; read back and checked</source>
   <translation>{names} nach {folder} geschrieben; zurückgelesen und geprüft</translation>
  </message>
  <message>
   <source>Wrote {name} to {folder}</source>
   <translation>{name} nach {folder} geschrieben</translation>
  </message>
  <message>
   <source>Zebra stripes</source>
   <translation>Zebrastreifen</translation>
  </message>
  <message>
   <source>Zerol pair</source>
   <translation>Zerolpaar</translation>
  </message>
  <message>
   <source>above pitch cone [mm]</source>
   <translation>über dem Teilkegel [mm]</translation>
  </message>
  <message>
   <source>addendum</source>
   <translation>Kopfhöhe</translation>
  </message>
  <message>
   <source>and {count} more</source>
   <translation>und {count} weitere</translation>
  </message>
  <message>
   <source>apex to crown</source>
   <translation>Spitze zur Kopfkante</translation>
  </message>
  <message>
   <source>at least {low}</source>
   <translation>mindestens {low}</translation>
  </message>
  <message>
   <source>at most {high}</source>
   <translation>höchstens {high}</translation>
  </message>
  <message>
   <source>at this cone distance</source>
   <translation>bei dieser Kegellänge</translation>
  </message>
  <message>
   <source>axial face width</source>
   <translation>axiale Zahnbreite</translation>
  </message>
  <message>
   <source>azimuth at the pitch cone</source>
   <translation>Azimut am Teilkegel</translation>
  </message>
  <message>
   <source>back face</source>
   <translation>Rückseite</translation>
  </message>
  <message>
   <source>base</source>
   <translation>Grund</translation>
  </message>
  <message>
   <source>base angle</source>
   <translation>Grundkegelwinkel</translation>
  </message>
  <message>
   <source>basic render</source>
   <translation>einfaches Zeichnen</translation>
  </message>
  <message>
   <source>best fit</source>
   <translation>beste Einpassung</translation>
  </message>
  <message>
   <source>binary</source>
   <translation>binär</translation>
  </message>
  <message>
   <source>body</source>
   <translation>Radkörper</translation>
  </message>
  <message>
   <source>bore</source>
   <translation>Bohrung</translation>
  </message>
  <message>
   <source>both flanks</source>
   <translation>beide Flanken</translation>
  </message>
  <message>
   <source>box {box} · read by {kernel}</source>
   <translation>Quader {box} · gelesen mit {kernel}</translation>
  </message>
  <message>
   <source>building…</source>
   <translation>wird gebaut…</translation>
  </message>
  <message>
   <source>by the taper</source>
   <translation>aus der Verjüngung</translation>
  </message>
  <message>
   <source>c_e = h_fe − h_ae of the mate</source>
   <translation>c_e = h_fe − h_ae des Gegenrads</translation>
  </message>
  <message>
   <source>c_i = h_fi − h_ai of the mate</source>
   <translation>c_i = h_fi − h_ai des Gegenrads</translation>
  </message>
  <message>
   <source>c_m = h_fm − h_am of the mate</source>
   <translation>c_m = h_fm − h_am des Gegenrads</translation>
  </message>
  <message>
   <source>closed</source>
   <translation>geschlossen</translation>
  </message>
  <message>
   <source>coast</source>
   <translation>Schub</translation>
  </message>
  <message>
   <source>common apex: tan θ_a = h_ae/R_e; constant clearance: θ_a = θ_f of the mate</source>
   <translation>gemeinsame Spitze: tan θ_a = h_ae/R_e; gleichbleibendes Kopfspiel: θ_a = θ_f des Gegenrads</translation>
  </message>
  <message>
   <source>computing the curvature…</source>
   <translation>Krümmung wird berechnet…</translation>
  </message>
  <message>
   <source>concave</source>
   <translation>konkav</translation>
  </message>
  <message>
   <source>concave fillet</source>
   <translation>konkave Fußrundung</translation>
  </message>
  <message>
   <source>concave flank</source>
   <translation>konkave Flanke</translation>
  </message>
  <message>
   <source>concave meridian</source>
   <translation>konkaver Meridian</translation>
  </message>
  <message>
   <source>convex</source>
   <translation>konvex</translation>
  </message>
  <message>
   <source>convex fillet</source>
   <translation>konvexe Fußrundung</translation>
  </message>
  <message>
   <source>convex flank</source>
   <translation>konvexe Flanke</translation>
  </message>
  <message>
   <source>convex meridian</source>
   <translation>konvexer Meridian</translation>
  </message>
  <message>
   <source>corner</source>
   <translation>Ecke</translation>
  </message>
  <message>
   <source>count</source>
   <translation>Anzahl</translation>
  </message>
  <message>
   <source>cumulative</source>
   <translation>summiert</translation>
  </message>
  <message>
   <source>curvature</source>
   <translation>Krümmung</translation>
  </message>
  <message>
   <source>cut</source>
   <translation>Schnitt</translation>
  </message>
  <message>
   <source>cut face</source>
   <translation>Schnittfläche</translation>
  </message>
  <message>
   <source>dedendum</source>
   <translation>Fußhöhe</translation>
  </message>
  <message>
   <source>dedendum angle</source>
   <translation>Fußwinkel</translation>
  </message>
  <message>
   <source>derived</source>
   <translation>abgeleitet</translation>
  </message>
  <message>
   <source>deviation</source>
   <translation>Abweichung</translation>
  </message>
  <message>
   <source>deviation [µm]</source>
   <translation>Abweichung [µm]</translation>
  </message>
  <message>
   <source>deviation {factor}</source>
   <translation>Abweichung {factor}</translation>
  </message>
  <message>
   <source>deviation {value}</source>
   <translation>Abweichung {value}</translation>
  </message>
  <message>
   <source>drive</source>
   <translation>Zug</translation>
  </message>
  <message>
   <source>ease-off</source>
   <translation>Ease-off</translation>
  </message>
  <message>
   <source>empty</source>
   <translation>leer</translation>
  </message>
  <message>
   <source>en</source>
   <translation>de</translation>
  </message>
  <message>
   <source>end</source>
   <translation>Zahnende</translation>
  </message>
  <message>
   <source>even</source>
   <translation>gleichmäßig</translation>
  </message>
  <message>
   <source>exact: tangent pitch cones, ρ_lim = r_c0</source>
   <translation>exakt: berührende Teilkegel, ρ_lim = r_c0</translation>
  </message>
  <message>
   <source>export of {label}</source>
   <translation>Export von {label}</translation>
  </message>
  <message>
   <source>face 0-1</source>
   <translation>Breite 0-1</translation>
  </message>
  <message>
   <source>face angle</source>
   <translation>Kopfkegelwinkel</translation>
  </message>
  <message>
   <source>face cone's apex</source>
   <translation>Spitze des Kopfkegels</translation>
  </message>
  <message>
   <source>faces: {count}</source>
   <translation>Flächen: {count}</translation>
  </message>
  <message>
   <source>fillet</source>
   <translation>Fußrundung</translation>
  </message>
  <message>
   <source>first method, mean</source>
   <translation>erste Methode, Mittel</translation>
  </message>
  <message>
   <source>flank</source>
   <translation>Flanke</translation>
  </message>
  <message>
   <source>flanks</source>
   <translation>Flanken</translation>
  </message>
  <message>
   <source>flat</source>
   <translation>eben</translation>
  </message>
  <message>
   <source>frame {n} of {all}</source>
   <translation>Bild {n} von {all}</translation>
  </message>
  <message>
   <source>from toe to heel [mm]</source>
   <translation>von der Zehe zur Ferse [mm]</translation>
  </message>
  <message>
   <source>front face</source>
   <translation>Vorderseite</translation>
  </message>
  <message>
   <source>gap</source>
   <translation>Spalt</translation>
  </message>
  <message>
   <source>gap {value} µm</source>
   <translation>Spalt {value} µm</translation>
  </message>
  <message>
   <source>gap µm</source>
   <translation>Spalt µm</translation>
  </message>
  <message>
   <source>gear</source>
   <translation>Rad</translation>
  </message>
  <message>
   <source>given</source>
   <translation>gegeben</translation>
  </message>
  <message>
   <source>given for the pinion; x₂ = −x₁</source>
   <translation>für das Ritzel gegeben; x₂ = −x₁</translation>
  </message>
  <message>
   <source>given for the wheel</source>
   <translation>für das Rad gegeben</translation>
  </message>
  <message>
   <source>given, or as a part of R_e</source>
   <translation>gegeben, oder als Teil von R_e</translation>
  </message>
  <message>
   <source>grid</source>
   <translation>Netz</translation>
  </message>
  <message>
   <source>guides</source>
   <translation>Führungen</translation>
  </message>
  <message>
   <source>heel</source>
   <translation>Ferse</translation>
  </message>
  <message>
   <source>hub</source>
   <translation>Nabe</translation>
  </message>
  <message>
   <source>inch</source>
   <translation>Zoll</translation>
  </message>
  <message>
   <source>inner cone distance</source>
   <translation>innere Teilkegellänge</translation>
  </message>
  <message>
   <source>inner outside diameter</source>
   <translation>innerer Außendurchmesser</translation>
  </message>
  <message>
   <source>inner pitch diameter</source>
   <translation>innerer Teilkreisdurchmesser</translation>
  </message>
  <message>
   <source>inner spiral angle</source>
   <translation>innerer Spiralwinkel</translation>
  </message>
  <message>
   <source>it ended without a reason</source>
   <translation>es endete ohne Angabe eines Grundes</translation>
  </message>
  <message>
   <source>it took too long</source>
   <translation>es dauerte zu lange</translation>
  </message>
  <message>
   <source>it was made of another state of the design; changed since: {fields}</source>
   <translation>sie entstand aus einem anderen Stand des Entwurfs; seither geändert: {fields}</translation>
  </message>
  <message>
   <source>kernel</source>
   <translation>Kern</translation>
  </message>
  <message>
   <source>kg mm²</source>
   <translation>kg mm²</translation>
  </message>
  <message>
   <source>kg m²</source>
   <translation>kg m²</translation>
  </message>
  <message>
   <source>lag of the wheel [″]</source>
   <translation>Nacheilen des Rads [″]</translation>
  </message>
  <message>
   <source>largest</source>
   <translation>größte</translation>
  </message>
  <message>
   <source>largest deviation [µm]</source>
   <translation>größte Abweichung [µm]</translation>
  </message>
  <message>
   <source>lb in²</source>
   <translation>lb in²</translation>
  </message>
  <message>
   <source>least</source>
   <translation>mindestens</translation>
  </message>
  <message>
   <source>left</source>
   <translation>links</translation>
  </message>
  <message>
   <source>left out</source>
   <translation>weggelassen</translation>
  </message>
  <message>
   <source>left-hand pinion</source>
   <translation>Ritzel linksspiralig</translation>
  </message>
  <message>
   <source>line</source>
   <translation>Linie</translation>
  </message>
  <message>
   <source>longest bar {length} {unit}</source>
   <translation>längster Balken {length} {unit}</translation>
  </message>
  <message>
   <source>max</source>
   <translation>max</translation>
  </message>
  <message>
   <source>max {largest} · mean {mean}</source>
   <translation>max {largest} · Mittel {mean}</translation>
  </message>
  <message>
   <source>mean</source>
   <translation>Mittel</translation>
  </message>
  <message>
   <source>mean cone distance</source>
   <translation>mittlere Teilkegellänge</translation>
  </message>
  <message>
   <source>mean normal module</source>
   <translation>mittlerer Normalmodul</translation>
  </message>
  <message>
   <source>mean pitch diameter</source>
   <translation>mittlerer Teilkreisdurchmesser</translation>
  </message>
  <message>
   <source>mean {value} µm</source>
   <translation>Mittel {value} µm</translation>
  </message>
  <message>
   <source>member</source>
   <translation>Rad</translation>
  </message>
  <message>
   <source>method</source>
   <translation>Verfahren</translation>
  </message>
  <message>
   <source>micro-geometry</source>
   <translation>Mikrogeometrie</translation>
  </message>
  <message>
   <source>middle of an edge</source>
   <translation>Kantenmitte</translation>
  </message>
  <message>
   <source>mm</source>
   <translation>mm</translation>
  </message>
  <message>
   <source>modifications</source>
   <translation>Modifikationen</translation>
  </message>
  <message>
   <source>more than {low}, up to {high}</source>
   <translation>über {low}, bis {high}</translation>
  </message>
  <message>
   <source>most</source>
   <translation>höchstens</translation>
  </message>
  <message>
   <source>names, colours, product structure</source>
   <translation>Namen, Farben, Produktstruktur</translation>
  </message>
  <message>
   <source>never saved</source>
   <translation>nie gespeichert</translation>
  </message>
  <message>
   <source>no</source>
   <translation>nein</translation>
  </message>
  <message>
   <source>no curvature to show</source>
   <translation>keine Krümmung zu zeigen</translation>
  </message>
  <message>
   <source>no deviation here</source>
   <translation>hier keine Abweichung</translation>
  </message>
  <message>
   <source>no font with Chinese characters was found, so the report is in English; install one, such as Noto Sans CJK</source>
   <translation>Es wurde keine Schrift mit chinesischen Zeichen gefunden, daher ist der Bericht englisch; installieren Sie eine, etwa Noto Sans CJK</translation>
  </message>
  <message>
   <source>non-uniform</source>
   <translation>ungleichmäßig</translation>
  </message>
  <message>
   <source>none</source>
   <translation>keine</translation>
  </message>
  <message>
   <source>not built</source>
   <translation>nicht gebaut</translation>
  </message>
  <message>
   <source>not computable</source>
   <translation>nicht berechenbar</translation>
  </message>
  <message>
   <source>not measured</source>
   <translation>nicht gemessen</translation>
  </message>
  <message>
   <source>not reached</source>
   <translation>nicht erreicht</translation>
  </message>
  <message>
   <source>not valid: {count} problems</source>
   <translation>ungültig: {count} Probleme</translation>
  </message>
  <message>
   <source>not valid: {problem}</source>
   <translation>ungültig: {problem}</translation>
  </message>
  <message>
   <source>nothing</source>
   <translation>nichts</translation>
  </message>
  <message>
   <source>number</source>
   <translation>Zahl</translation>
  </message>
  <message>
   <source>offset axes</source>
   <translation>Achsversatz</translation>
  </message>
  <message>
   <source>one tooth</source>
   <translation>ein Zahn</translation>
  </message>
  <message>
   <source>optimised</source>
   <translation>optimiert</translation>
  </message>
  <message>
   <source>outer cone distance</source>
   <translation>äußere Teilkegellänge</translation>
  </message>
  <message>
   <source>outer cone distance {distance} mm, face width {width} mm (wheel)</source>
   <translation>äußere Kegeldistanz {distance} mm, Zahnbreite {width} mm (Rad)</translation>
  </message>
  <message>
   <source>outer module</source>
   <translation>Außenmodul</translation>
  </message>
  <message>
   <source>outer pitch diameter</source>
   <translation>äußerer Teilkreisdurchmesser</translation>
  </message>
  <message>
   <source>outer spiral angle</source>
   <translation>äußerer Spiralwinkel</translation>
  </message>
  <message>
   <source>outside diameter</source>
   <translation>Außendurchmesser</translation>
  </message>
  <message>
   <source>oz in²</source>
   <translation>oz in²</translation>
  </message>
  <message>
   <source>pair</source>
   <translation>Paar</translation>
  </message>
  <message>
   <source>paper, equation {number}</source>
   <translation>Arbeit, Gleichung {number}</translation>
  </message>
  <message>
   <source>parameters</source>
   <translation>Parameter</translation>
  </message>
  <message>
   <source>pinion</source>
   <translation>Ritzel</translation>
  </message>
  <message>
   <source>pipe along the tooth trace</source>
   <translation>Rohr entlang der Flankenlinie</translation>
  </message>
  <message>
   <source>pitch angle</source>
   <translation>Teilkegelwinkel</translation>
  </message>
  <message>
   <source>pitch error [µm]</source>
   <translation>Teilungsabweichung [µm]</translation>
  </message>
  <message>
   <source>plane that touches the wheel's face cone</source>
   <translation>Ebene am Kopfkegel des Rads</translation>
  </message>
  <message>
   <source>plane that touches the wheel's root cone</source>
   <translation>Ebene am Fußkegel des Rads</translation>
  </message>
  <message>
   <source>point of the 7 × 7 series, toe to heel</source>
   <translation>Punkt der Reihe 7 × 7, Zehe bis Ferse</translation>
  </message>
  <message>
   <source>point_cloud</source>
   <translation>Punktwolke</translation>
  </message>
  <message>
   <source>points</source>
   <translation>Punkte</translation>
  </message>
  <message>
   <source>points along each side</source>
   <translation>Punkte je Seite</translation>
  </message>
  <message>
   <source>poles</source>
   <translation>Pole</translation>
  </message>
  <message>
   <source>positions</source>
   <translation>Stellungen</translation>
  </message>
  <message>
   <source>process {number}</source>
   <translation>Prozess {number}</translation>
  </message>
  <message>
   <source>process {number} on {host}</source>
   <translation>Prozess {number} auf {host}</translation>
  </message>
  <message>
   <source>profile 0-1</source>
   <translation>Profil 0-1</translation>
  </message>
  <message>
   <source>profile_sweep</source>
   <translation>Profil-Sweep</translation>
  </message>
  <message>
   <source>psi, trace</source>
   <translation>psi, Linie</translation>
  </message>
  <message>
   <source>published</source>
   <translation>gedruckt</translation>
  </message>
  <message>
   <source>record: {name}</source>
   <translation>Prüfbericht: {name}</translation>
  </message>
  <message>
   <source>right</source>
   <translation>rechts</translation>
  </message>
  <message>
   <source>right-hand pinion</source>
   <translation>Ritzel rechtsspiralig</translation>
  </message>
  <message>
   <source>rim</source>
   <translation>Kranz</translation>
  </message>
  <message>
   <source>rms</source>
   <translation>rms</translation>
  </message>
  <message>
   <source>roll angle at the pitch cone</source>
   <translation>Wälzwinkel am Teilkegel</translation>
  </message>
  <message>
   <source>root</source>
   <translation>Fuß</translation>
  </message>
  <message>
   <source>root angle</source>
   <translation>Fußkegelwinkel</translation>
  </message>
  <message>
   <source>root cone's apex</source>
   <translation>Spitze des Fußkegels</translation>
  </message>
  <message>
   <source>rotating_line</source>
   <translation>Rollende Gerade</translation>
  </message>
  <message>
   <source>second method, mean</source>
   <translation>zweite Methode, Mittel</translation>
  </message>
  <message>
   <source>seconds</source>
   <translation>Sekunden</translation>
  </message>
  <message>
   <source>seconds for both flanks</source>
   <translation>Sekunden für beide Flanken</translation>
  </message>
  <message>
   <source>section 3</source>
   <translation>Abschnitt 3</translation>
  </message>
  <message>
   <source>section 4</source>
   <translation>Abschnitt 4</translation>
  </message>
  <message>
   <source>section 5</source>
   <translation>Abschnitt 5</translation>
  </message>
  <message>
   <source>sections</source>
   <translation>Schnitte</translation>
  </message>
  <message>
   <source>series</source>
   <translation>Reihe</translation>
  </message>
  <message>
   <source>shank</source>
   <translation>Schaft</translation>
  </message>
  <message>
   <source>shift</source>
   <translation>verschieben</translation>
  </message>
  <message>
   <source>single</source>
   <translation>einzeln</translation>
  </message>
  <message>
   <source>skin</source>
   <translation>Haut</translation>
  </message>
  <message>
   <source>smallest</source>
   <translation>kleinste</translation>
  </message>
  <message>
   <source>solid of the {member}</source>
   <translation>Volumenkörper: {member}</translation>
  </message>
  <message>
   <source>solids</source>
   <translation>Körper</translation>
  </message>
  <message>
   <source>solids: {count}</source>
   <translation>Körper: {count}</translation>
  </message>
  <message>
   <source>spacing</source>
   <translation>Abstände</translation>
  </message>
  <message>
   <source>square to the pitch cone</source>
   <translation>rechtwinklig zum Teilkegel</translation>
  </message>
  <message>
   <source>surfaces</source>
   <translation>Flächen</translation>
  </message>
  <message>
   <source>surfaces, for older programs</source>
   <translation>Flächen, für ältere Programme</translation>
  </message>
  <message>
   <source>sweep</source>
   <translation>Sweep</translation>
  </message>
  <message>
   <source>taking pictures of the views</source>
   <translation>Bilder der Ansichten werden aufgenommen</translation>
  </message>
  <message>
   <source>tan β(ρ) = ρ ψ_t′(ρ) at R_e</source>
   <translation>tan β(ρ) = ρ ψ_t′(ρ) bei R_e</translation>
  </message>
  <message>
   <source>tan β(ρ) = ρ ψ_t′(ρ) at R_i</source>
   <translation>tan β(ρ) = ρ ψ_t′(ρ) bei R_i</translation>
  </message>
  <message>
   <source>tan β(ρ) = ρ ψ_t′(ρ) at R_m</source>
   <translation>tan β(ρ) = ρ ψ_t′(ρ) bei R_m</translation>
  </message>
  <message>
   <source>teeth</source>
   <translation>Zähne</translation>
  </message>
  <message>
   <source>text</source>
   <translation>Text</translation>
  </message>
  <message>
   <source>the CAD kernel's own</source>
   <translation>das des CAD-Kerns</translation>
  </message>
  <message>
   <source>the CAD process died each time it tried</source>
   <translation>der CAD-Prozess ist bei jedem Versuch abgestürzt</translation>
  </message>
  <message>
   <source>the file is gone</source>
   <translation>die Datei ist fort</translation>
  </message>
  <message>
   <source>the file is gone; its record is still there</source>
   <translation>die Datei ist fort; ihr Prüfbericht ist noch da</translation>
  </message>
  <message>
   <source>the file is not as it was written: its checksum is another</source>
   <translation>die Datei ist nicht wie geschrieben: ihre Prüfsumme ist eine andere</translation>
  </message>
  <message>
   <source>the mate has no flank here</source>
   <translation>das Gegenrad hat hier keine Flanke</translation>
  </message>
  <message>
   <source>the paper's own gear: {low} … {high} µm, means {means} µm</source>
   <translation>das Rad der Arbeit: {low} … {high} µm, Mittel {means} µm</translation>
  </message>
  <message>
   <source>the record does not say what was found</source>
   <translation>der Prüfbericht sagt nicht, was gefunden wurde</translation>
  </message>
  <message>
   <source>the views are not there yet</source>
   <translation>die Ansichten sind noch nicht da</translation>
  </message>
  <message>
   <source>the window shows solids and not the flanks</source>
   <translation>das Fenster zeigt Körper und nicht die Flanken</translation>
  </message>
  <message>
   <source>theory, section {number}</source>
   <translation>Theorie, Abschnitt {number}</translation>
  </message>
  <message>
   <source>third method, mean</source>
   <translation>dritte Methode, Mittel</translation>
  </message>
  <message>
   <source>this takes more memory than the {limit} MB that the CAD kernel may have; ask for less, or raise the limit in the preferences</source>
   <translation>das braucht mehr Speicher als die {limit} MB, die der CAD-Kern haben darf; weniger verlangen oder die Grenze in den Einstellungen anheben</translation>
  </message>
  <message>
   <source>tip</source>
   <translation>Kopf</translation>
  </message>
  <message>
   <source>toe</source>
   <translation>Zehe</translation>
  </message>
  <message>
   <source>tolerance</source>
   <translation>Toleranz</translation>
  </message>
  <message>
   <source>tolerance {value}</source>
   <translation>Toleranz {value}</translation>
  </message>
  <message>
   <source>tooth</source>
   <translation>Zahn</translation>
  </message>
  <message>
   <source>triangles alone</source>
   <translation>nur Dreiecke</translation>
  </message>
  <message>
   <source>triangles in colour, for viewers</source>
   <translation>farbige Dreiecke, für Betrachter</translation>
  </message>
  <message>
   <source>triangles within {um} µm of theory ({limit} µm allowed)</source>
   <translation>Dreiecke innerhalb {um} µm der Theorie ({limit} µm erlaubt)</translation>
  </message>
  <message>
   <source>triangles, for printing</source>
   <translation>Dreiecke, zum Drucken</translation>
  </message>
  <message>
   <source>turn</source>
   <translation>drehen</translation>
  </message>
  <message>
   <source>turn of contact over the face at half the depth, over the pitch</source>
   <translation>Drehung des Kontakts über die Breite in halber Höhe, durch die Teilung</translation>
  </message>
  <message>
   <source>turn of contact over the profile in the middle of the face, over the pitch</source>
   <translation>Drehung des Kontakts über das Profil in Breitenmitte, durch die Teilung</translation>
  </message>
  <message>
   <source>turn of contact over the whole flank, over the pitch</source>
   <translation>Drehung des Kontakts über die ganze Flanke, durch die Teilung</translation>
  </message>
  <message>
   <source>turn of the pinion [°]</source>
   <translation>Drehung des Ritzels [°]</translation>
  </message>
  <message>
   <source>updating…</source>
   <translation>wird erneuert…</translation>
  </message>
  <message>
   <source>updating… (max was {largest})</source>
   <translation>wird erneuert… (max war {largest})</translation>
  </message>
  <message>
   <source>valid</source>
   <translation>gültig</translation>
  </message>
  <message>
   <source>waiting for the CAD kernel</source>
   <translation>wartet auf den CAD-Kern</translation>
  </message>
  <message>
   <source>waiting for the CAD kernel…</source>
   <translation>wartet auf den CAD-Kern…</translation>
  </message>
  <message>
   <source>waiting for the CAD process</source>
   <translation>wartet auf den CAD-Prozess</translation>
  </message>
  <message>
   <source>waiting…</source>
   <translation>wartet…</translation>
  </message>
  <message>
   <source>wheel</source>
   <translation>Rad</translation>
  </message>
  <message>
   <source>whole gear</source>
   <translation>ganzes Rad</translation>
  </message>
  <message>
   <source>with the backlash's share</source>
   <translation>mit dem Anteil des Flankenspiels</translation>
  </message>
  <message>
   <source>within</source>
   <translation>innerhalb</translation>
  </message>
  <message>
   <source>writing…</source>
   <translation>wird geschrieben…</translation>
  </message>
  <message>
   <source>yes</source>
   <translation>ja</translation>
  </message>
  <message>
   <source>{count} changed</source>
   <translation>{count} geändert</translation>
  </message>
  <message>
   <source>{count} constructions failed. </source>
   <translation>{count} Aufbauten misslangen. </translation>
  </message>
  <message>
   <source>{count} entries, {bad} warnings or errors</source>
   <translation>{count} Einträge, {bad} Warnungen oder Fehler</translation>
  </message>
  <message>
   <source>{count} of {all}</source>
   <translation>{count} von {all}</translation>
  </message>
  <message>
   <source>{count} of {all} values differ; the difference is other minus this.</source>
   <translation>{count} von {all} Werten verschieden; Unterschied ist anderer minus dieser.</translation>
  </message>
  <message>
   <source>{count} pages, {size:.1f} MB</source>
   <translation>{count} Seiten, {size:.1f} MB</translation>
  </message>
  <message>
   <source>{count} problems</source>
   <translation>{count} Probleme</translation>
  </message>
  <message>
   <source>{count} steps</source>
   <translation>{count} Stufen</translation>
  </message>
  <message>
   <source>{count} warnings</source>
   <translation>{count} Warnungen</translation>
  </message>
  <message>
   <source>{count}: the last good model stays</source>
   <translation>{count}: das letzte gute Modell bleibt</translation>
  </message>
  <message>
   <source>{curve}, spiral angle {spiral}° ({place}), pressure angle {pressure}° ({kind})</source>
   <translation>{curve}, Spiralwinkel {spiral}° ({place}), Eingriffswinkel {pressure}° ({kind})</translation>
  </message>
  <message>
   <source>{direction}, {size}″ peak to peak</source>
   <translation>{direction}, {size}″ Spitze zu Spitze</translation>
  </message>
  <message>
   <source>{direction}: ease-off and lines of contact</source>
   <translation>{direction}: Ease-off und Berührlinien</translation>
  </message>
  <message>
   <source>{faces} faces · flanks within {largest} · built in {took}</source>
   <translation>{faces} Flächen · Flanken innerhalb {largest} · gebaut in {took}</translation>
  </message>
  <message>
   <source>{face}, tooth {number}</source>
   <translation>{face}, Zahn {number}</translation>
  </message>
  <message>
   <source>{fields} and {count} more</source>
   <translation>{fields} und {count} weitere</translation>
  </message>
  <message>
   <source>{file}, against the {member}</source>
   <translation>{file}, gegen {member}</translation>
  </message>
  <message>
   <source>{file}, against the {member}.</source>
   <translation>{file}, verglichen mit: {member}.</translation>
  </message>
  <message>
   <source>{file}, against the {member}: points of {flanks} flank faces of {faces}</source>
   <translation>{file}, gegen {member}: Punkte von {flanks} Flanken aus {faces} Flächen</translation>
  </message>
  <message>
   <source>{file}, against the {member}: points of {flanks} flank faces of {faces}.</source>
   <translation>{file}, verglichen mit: {member}; Punkte von {flanks} Flankenflächen von {faces} Flächen.</translation>
  </message>
  <message>
   <source>{flank}, {member}: signed deviation, plus is metal added; each map has a scale of its own.</source>
   <translation>{flank}, {member}: Abweichung mit Vorzeichen, plus bedeutet mehr Werkstoff; jede Karte hat ihre eigene Skala.</translation>
  </message>
  <message>
   <source>{keys} belongs to “{command}”, which would lose it.</source>
   <translation>{keys} gehört zu „{command}“, das sie verlöre.</translation>
  </message>
  <message>
   <source>{low} to {high}</source>
   <translation>{low} bis {high}</translation>
  </message>
  <message>
   <source>{member} {face}: within {largest} µm of theory ({limit} µm allowed)</source>
   <translation>{member} {face}: innerhalb {largest} µm der Theorie ({limit} µm erlaubt)</translation>
  </message>
  <message>
   <source>{member}, {face}, tooth {number}</source>
   <translation>{member}, {face}, Zahn {number}</translation>
  </message>
  <message>
   <source>{member}, {flank} flank</source>
   <translation>{member}, Flanke {flank}</translation>
  </message>
  <message>
   <source>{member}, {flank} flank: all points of the deviation map</source>
   <translation>{member}, Flanke {flank}: alle Punkte der Abweichungskarte</translation>
  </message>
  <message>
   <source>{member}, {method}: 5 × 9 points, plus is upwards.</source>
   <translation>{member}, {method}: 5 × 9 Punkte, plus ist oben.</translation>
  </message>
  <message>
   <source>{member}: Gaussian curvature, theory and the optimised surfaces on one scale.</source>
   <translation>{member}: Gaußsche Krümmung, Theorie und die optimierten Flächen auf einer Skala.</translation>
  </message>
  <message>
   <source>{member}: deviation at 7 × 7 points of each flank; dotted: the means that the paper states.</source>
   <translation>{member}: Abweichung an 7 × 7 Punkten jeder Flanke; gepunktet: die Mittelwerte, die die Veröffentlichung nennt.</translation>
  </message>
  <message>
   <source>{member}: largest deviation over both flanks against the effort.</source>
   <translation>{member}: größte Abweichung über beide Flanken gegen den Aufwand.</translation>
  </message>
  <message>
   <source>{member}: measured deviation, mean of all teeth; a bar upwards and red is metal added.</source>
   <translation>{member}: gemessene Abweichung, Mittel aller Zähne; ein Balken nach oben und Rot bedeuten mehr Werkstoff.</translation>
  </message>
  <message>
   <source>{member}: no blank yet</source>
   <translation>{member}: noch kein Radkörper</translation>
  </message>
  <message>
   <source>{member}: pitch errors of the teeth that were measured.</source>
   <translation>{member}: Teilungsabweichungen der gemessenen Zähne.</translation>
  </message>
  <message>
   <source>{method}: modifications left out</source>
   <translation>{method}: ohne Modifikationen</translation>
  </message>
  <message>
   <source>{method}: the nearest flank that a rigid line sweeps</source>
   <translation>{method}: nächste Flanke, die eine starre Gerade überstreicht</translation>
  </message>
  <message>
   <source>{moment} by {program}, {kernel}</source>
   <translation>{moment} mit {program}, {kernel}</translation>
  </message>
  <message>
   <source>{name} (missing)</source>
   <translation>{name} (fehlt)</translation>
  </message>
  <message>
   <source>{name} (read-only)</source>
   <translation>{name} (schreibgeschützt)</translation>
  </message>
  <message>
   <source>{name} is no longer on the disk; Save writes it again.</source>
   <translation>{name} ist nicht mehr auf der Platte; Speichern schreibt sie neu.</translation>
  </message>
  <message>
   <source>{name} was not opened: it has {count} problems, the first at {problem}</source>
   <translation>{name} nicht geöffnet: {count} Probleme, das erste bei {problem}</translation>
  </message>
  <message>
   <source>{name} was not opened: {problem}</source>
   <translation>{name} nicht geöffnet: {problem}</translation>
  </message>
  <message>
   <source>{name} was not saved: it is open in another GearStudio window ({holder})</source>
   <translation>{name} nicht gespeichert: in einem anderen GearStudio-Fenster offen ({holder})</translation>
  </message>
  <message>
   <source>{name} was not saved: {problem}</source>
   <translation>{name} nicht gespeichert: {problem}</translation>
  </message>
  <message>
   <source>{name}, cumulative</source>
   <translation>{name}, Summe</translation>
  </message>
  <message>
   <source>{name}, single</source>
   <translation>{name}, einzeln</translation>
  </message>
  <message>
   <source>{number} of {count}</source>
   <translation>{number} von {count}</translation>
  </message>
  <message>
   <source>{passed} of {all} published values agree to the last printed digit</source>
   <translation>{passed} von {all} veröffentlichten Werten stimmen bis zur letzten gedruckten Ziffer</translation>
  </message>
  <message>
   <source>{pinion} / {wheel} teeth, outer module {module} mm, shaft angle {angle}°, {hand}</source>
   <translation>{pinion} / {wheel} Zähne, äußerer Modul {module} mm, Achsenwinkel {angle}°, {hand}</translation>
  </message>
  <message>
   <source>{quantity}, {flank}</source>
   <translation>{quantity}, {flank}</translation>
  </message>
  <message>
   <source>{size} µm for the optimised variants</source>
   <translation>{size} µm für die optimierten Varianten</translation>
  </message>
  <message>
   <source>{summary} ({section} of the paper)</source>
   <translation>{summary} ({section} der Arbeit)</translation>
  </message>
  <message>
   <source>{text} ({done} of {all})</source>
   <translation>{text} ({done} von {all})</translation>
  </message>
  <message>
   <source>{title} [{unit}]
Drag an end of the bar to change the range, double-click to type it. Grey: no value there</source>
   <translation>{title} [{unit}]
Ein Ende ziehen ändert den Bereich, Doppelklick gibt ihn ein. Grau: kein Wert</translation>
  </message>
  <message>
   <source>{title} curvature [{unit}]</source>
   <translation>Krümmung: {title} [{unit}]</translation>
  </message>
  <message>
   <source>{title} curvature less theory [{unit}]</source>
   <translation>Krümmung abzüglich Theorie: {title} [{unit}]</translation>
  </message>
  <message>
   <source>{title}: a number from {low} to {high} {unit}, or nothing</source>
   <translation>{title}: eine Zahl von {low} bis {high} {unit}, oder nichts</translation>
  </message>
  <message>
   <source>{title}[*] – GearStudio</source>
   <translation>{title}[*] – GearStudio</translation>
  </message>
  <message>
   <source>{view}: {problem}</source>
   <translation>{view}: {problem}</translation>
  </message>
  <message>
   <source>{words}; {failed} do not.</source>
   <translation>{words}; {failed} nicht.</translation>
  </message>
  <message>
   <source>{w} × {h} pixels</source>
   <translation>{w} × {h} Bildpunkte</translation>
  </message>
  <message>
   <source>×1, as it is</source>
   <translation>×1, wie es ist</translation>
  </message>
  <message>
   <source>Σ  shaft angle</source>
   <translation>Σ  Achsenwinkel</translation>
  </message>
  <message>
   <source>γ + γ_mate − arccos(cos δ_a/cos δ_b) of the mate</source>
   <translation>γ + γ_mate − arccos(cos δ_a/cos δ_b) des Gegenrads</translation>
  </message>
  <message>
   <source>“{command}”: usual keys {keys}</source>
   <translation>„{command}“: übliche Tasten {keys}</translation>
  </message>
  <message>
   <source>“{name}” is not known here</source>
   <translation>„{name}“ ist hier nicht bekannt</translation>
  </message>
  <message>
   <source>“{name}” is open in another GearStudio window ({holder}).</source>
   <translation>„{name}“ ist in einem anderen GearStudio-Fenster offen ({holder}).</translation>
  </message>
  <message>
   <source>“{name}” was changed by another program.</source>
   <translation>„{name}“ wurde von einem anderen Programm geändert.</translation>
  </message>
  <message>
   <source>“{text}” is neither a number nor a sum</source>
   <translation>„{text}“ ist weder Zahl noch Rechnung</translation>
  </message>
  <message>
   <source>“{unit}” does not suit this field</source>
   <translation>„{unit}“ passt nicht zu diesem Feld</translation>
  </message>
  <message>
   <source>✓ pass</source>
   <translation>✓ stimmt</translation>
  </message>
  <message>
   <source>✗ fail</source>
   <translation>✗ falsch</translation>
  </message>
 </context>
 <context>
  <name>Sentences</name>
  <message>
   <source>"toe" is defined for the Archimedean curve only, and the curve is "{0}"; use "mean", or the curve "archimedean"</source>
   <translation>"toe" gibt es nur für die archimedische Kurve, die Kurve ist "{0}"; "mean" wählen, oder die Kurve "archimedean"</translation>
  </message>
  <message>
   <source>, where {0} mm could be a measured deviation</source>
   <translation>, wo {0} mm eine gemessene Abweichung sein könnten</translation>
  </message>
  <message>
   <source>; use an offset of 0 mm</source>
   <translation>; einen Achsversatz von 0 mm nehmen</translation>
  </message>
  <message>
   <source>; use {0} mm or nearer to 0</source>
   <translation>; {0} mm oder näher an 0 nehmen</translation>
  </message>
  <message>
   <source>Addendum angle</source>
   <translation>Kopfwinkel</translation>
  </message>
  <message>
   <source>Clearance over depth</source>
   <translation>Kopfspiel zu Zahnhöhe</translation>
  </message>
  <message>
   <source>Dedendum angle</source>
   <translation>Fußwinkel</translation>
  </message>
  <message>
   <source>Depth factor</source>
   <translation>Zahnhöhenfaktor</translation>
  </message>
  <message>
   <source>Depth system</source>
   <translation>Zahnhöhensystem</translation>
  </message>
  <message>
   <source>From the wheel's pitch cone to its face cone; leave empty to take the taper's.</source>
   <translation>Vom Teilkegel des Rads zu seinem Kopfkegel; leer: aus der Verjüngung.</translation>
  </message>
  <message>
   <source>From the wheel's root cone to its pitch cone; leave empty to take the taper's.</source>
   <translation>Vom Fußkegel des Rads zu seinem Teilkegel; leer: aus der Verjüngung.</translation>
  </message>
  <message>
   <source>Mean addendum factor</source>
   <translation>Mittlerer Kopfhöhenfaktor</translation>
  </message>
  <message>
   <source>Outer module: the factors of the tooth, over the outer module at the heel. ISO 23509: factors of the mean normal module at the mean point, with a taper.</source>
   <translation>Außenmodul: die Faktoren des Zahns, mal Außenmodul an der Ferse. ISO 23509: Faktoren des mittleren Normalmoduls im Mittelpunkt, mit Verjüngung.</translation>
  </message>
  <message>
   <source>Standard: root lines through the pitch apex. Uniform: the same depth from toe to heel. Duplex: constant slot width. Tilted root: constant slot width, but not steeper than 1.3 times standard.</source>
   <translation>Standard: Fußlinien durch die Teilkegelspitze. Gleich hoch: dieselbe Höhe von Zehe bis Ferse. Duplex: gleich weite Lücke. Geneigter Fuß: gleich weite Lücke, aber höchstens 1,3-mal so steil wie Standard.</translation>
  </message>
  <message>
   <source>The wheel's mean addendum over working depth; leave empty for 0.21 + 0.29/u₉₀².</source>
   <translation>Mittlere Kopfhöhe des Rads durch gemeinsame Zahnhöhe; leer: 0,21 + 0,29/u₉₀².</translation>
  </message>
  <message>
   <source>Thickness factor</source>
   <translation>Zahndickenfaktor</translation>
  </message>
  <message>
   <source>Thickness that the pinion's teeth gain over the wheel's, over mean normal module.</source>
   <translation>Dicke, die die Ritzelzähne gegenüber dem Rad gewinnen, durch mittleren Normalmodul.</translation>
  </message>
  <message>
   <source>Tip clearance over working depth.</source>
   <translation>Kopfspiel durch gemeinsame Zahnhöhe.</translation>
  </message>
  <message>
   <source>Working depth at the mean point over mean normal module.</source>
   <translation>Gemeinsame Zahnhöhe im Mittelpunkt durch mittleren Normalmodul.</translation>
  </message>
  <message>
   <source>a back face {0} mm from the apex cuts into the roots at the heel; use at least {1} mm</source>
   <translation>eine Rückfläche {0} mm von der Spitze schneidet in die Füße an der Ferse; mindestens {1} mm nehmen</translation>
  </message>
  <message>
   <source>a bore of {0} mm leaves no wall under the roots; use at most {1} mm</source>
   <translation>eine Bohrung von {0} mm lässt keine Wand unter den Füßen; höchstens {1} mm nehmen</translation>
  </message>
  <message>
   <source>a chamfer at the end of the teeth cuts a face more than once</source>
   <translation>eine Endfase schneidet eine Fläche mehr als einmal</translation>
  </message>
  <message>
   <source>a chamfer at the end of the teeth does not cut off their tips alone</source>
   <translation>eine Endfase nimmt nicht nur die Zahnköpfe weg</translation>
  </message>
  <message>
   <source>a chamfer of {0} mm is too small to be modelled; use 0 for none, or at least {1} mm</source>
   <translation>eine Fase von {0} mm ist zu klein zum Modellieren; 0 für keine, oder mindestens {1} mm nehmen</translation>
  </message>
  <message>
   <source>a chamfer of {0} mm leaves no tip between toe and heel or reaches the roots; use at most {1} mm</source>
   <translation>eine Fase von {0} mm lässt keinen Kopf zwischen Zehe und Ferse oder erreicht die Füße; höchstens {1} mm nehmen</translation>
  </message>
  <message>
   <source>a chart is saved as {0}, not as {1}</source>
   <translation>ein Diagramm wird als {0} gespeichert, nicht als {1}</translation>
  </message>
  <message>
   <source>a constant slot width would taper the depth by {0}°, beyond {1}°; use {2}</source>
   <translation>gleich weite Lücke würde die Höhe um {0}° verjüngen, über {1}°; {2} nehmen</translation>
  </message>
  <message>
   <source>a coordinate of the measured points is not a number</source>
   <translation>eine Koordinate der Messpunkte ist keine Zahl</translation>
  </message>
  <message>
   <source>a cutter of radius {0} mm does not cross the wheel's whole face width; {1}</source>
   <translation>ein Messerkopf mit Radius {0} mm überquert nicht die ganze Zahnbreite des Rads; {1}</translation>
  </message>
  <message>
   <source>a cutter of radius {0} mm does not cross the whole face width</source>
   <translation>ein Messerkopf mit Radius {0} mm überquert nicht die ganze Zahnbreite</translation>
  </message>
  <message>
   <source>a cutter radius of {0} mm</source>
   <translation>einem Messerkopfradius von {0} mm</translation>
  </message>
  <message>
   <source>a document (PDF)</source>
   <translation>ein Dokument (PDF)</translation>
  </message>
  <message>
   <source>a face is missing or not valid</source>
   <translation>eine Fläche fehlt oder ist ungültig</translation>
  </message>
  <message>
   <source>a face width of {0} mm does not fit a wheel of {1} mm; use less than {2} mm</source>
   <translation>eine Zahnbreite von {0} mm passt nicht zu einem Rad von {1} mm; weniger als {2} mm nehmen</translation>
  </message>
  <message>
   <source>a fillet of {0} mm on the {1} reaches into the {2} flank that meets the wheel's tip</source>
   <translation>eine Fußrundung von {0} mm am {1} reicht in die Flanke ({2}), die den Kopf des Rads trifft</translation>
  </message>
  <message>
   <source>a grid of {0} x {1} points has no area; use 2 or more each way</source>
   <translation>ein Netz von {0} x {1} Punkten hat keine Fläche; je Richtung mindestens 2 nehmen</translation>
  </message>
  <message>
   <source>a grid of {0} x {1} points is too coarse for a contact analysis; use 3 or more</source>
   <translation>ein Netz von {0} x {1} Punkten ist zu grob für die Kontaktanalyse; mindestens 3 nehmen</translation>
  </message>
  <message>
   <source>a hub of {0} mm must lie between the bore and the rim; use more than {1} and less than {2} mm</source>
   <translation>eine Nabe von {0} mm muss zwischen Bohrung und Kranz liegen; mehr als {1} und weniger als {2} mm nehmen</translation>
  </message>
  <message>
   <source>a hub {0} mm long reaches beyond the toe; use at most {1} mm</source>
   <translation>eine {0} mm lange Nabe reicht über die Zehe hinaus; höchstens {1} mm nehmen</translation>
  </message>
  <message>
   <source>a larger pressure angle or more teeth</source>
   <translation>einen größeren Eingriffswinkel oder mehr Zähne</translation>
  </message>
  <message>
   <source>a marking compound {0} µm thick leaves no mark; use more than 0</source>
   <translation>eine Tuschierpaste von {0} µm hinterlässt keine Spur; mehr als 0 nehmen</translation>
  </message>
  <message>
   <source>a misalignment and the thickness of the marking compound must be finite numbers</source>
   <translation>Einbaufehler und Dicke der Tuschierpaste müssen endliche Zahlen sein</translation>
  </message>
  <message>
   <source>a model (GLB)</source>
   <translation>ein Modell (GLB)</translation>
  </message>
  <message>
   <source>a model (STEP)</source>
   <translation>ein Modell (STEP)</translation>
  </message>
  <message>
   <source>a model (STL)</source>
   <translation>ein Modell (STL)</translation>
  </message>
  <message>
   <source>a narrower face width</source>
   <translation>eine kleinere Zahnbreite</translation>
  </message>
  <message>
   <source>a number in it has thousands of digits</source>
   <translation>eine Zahl darin hat Tausende von Stellen</translation>
  </message>
  <message>
   <source>a number needs digits on both sides of its point; write “{0} = {1}”</source>
   <translation>eine Zahl braucht Ziffern auf beiden Seiten des Punktes; schreiben Sie „{0} = {1}“</translation>
  </message>
  <message>
   <source>a number stands without a unit, which is always the same; write “{0} = {1}”</source>
   <translation>eine Zahl steht ohne Einheit, denn die ist immer dieselbe; schreiben Sie „{0} = {1}“</translation>
  </message>
  <message>
   <source>a part of the path is a file, not a folder</source>
   <translation>ein Teil des Pfads ist eine Datei, kein Ordner</translation>
  </message>
  <message>
   <source>a picture (GIF)</source>
   <translation>ein Bild (GIF)</translation>
  </message>
  <message>
   <source>a picture (JPEG)</source>
   <translation>ein Bild (JPEG)</translation>
  </message>
  <message>
   <source>a picture (PNG)</source>
   <translation>ein Bild (PNG)</translation>
  </message>
  <message>
   <source>a picture needs a name that ends in {0}</source>
   <translation>ein Bild braucht einen Namen, der auf {0} endet</translation>
  </message>
  <message>
   <source>a pressure angle of {0}°</source>
   <translation>einem Eingriffswinkel von {0}°</translation>
  </message>
  <message>
   <source>a profile shift of {0}</source>
   <translation>einer Profilverschiebung von {0}</translation>
  </message>
  <message>
   <source>a shaft angle of {0}° makes the wheel's pitch cone {1}°; it must stay below {2}°: use at most {3}°</source>
   <translation>ein Achsenwinkel von {0}° macht den Teilkegel des Rads {1}°; er muss unter {2}° bleiben: höchstens {3}° nehmen</translation>
  </message>
  <message>
   <source>a shank of {0} mm is wider than the back face; use at most {1} mm</source>
   <translation>ein Schaft von {0} mm ist breiter als die Rückfläche; höchstens {1} mm nehmen</translation>
  </message>
  <message>
   <source>a smaller addendum factor, profile shift or pressure angle</source>
   <translation>kleineren Kopfhöhenfaktor, Profilverschiebung oder Eingriffswinkel</translation>
  </message>
  <message>
   <source>a smaller fillet factor</source>
   <translation>einen kleineren Fußrundungsfaktor</translation>
  </message>
  <message>
   <source>a smaller fillet factor or deeper teeth</source>
   <translation>einen kleineren Fußrundungsfaktor oder höhere Zähne</translation>
  </message>
  <message>
   <source>a smaller one</source>
   <translation>einen kleineren Wert</translation>
  </message>
  <message>
   <source>a smaller profile shift and backlash</source>
   <translation>kleinere Profilverschiebung und kleineres Flankenspiel</translation>
  </message>
  <message>
   <source>a smaller profile shift or pressure angle</source>
   <translation>kleinere Profilverschiebung oder kleineren Eingriffswinkel</translation>
  </message>
  <message>
   <source>a spiral angle of {0}°</source>
   <translation>einem Spiralwinkel von {0}°</translation>
  </message>
  <message>
   <source>a spiral angle of {0}° on the {1} with an offset of {2} mm turns the {3}'s teeth against their hand, to {4}°; {5} or an offset of the other sign</source>
   <translation>ein Spiralwinkel von {0}° am {1} dreht bei einem Achsversatz von {2} mm die Zähne am {3} gegen ihre Spiralrichtung, auf {4}°; {5} oder einen Achsversatz mit anderem Vorzeichen nehmen</translation>
  </message>
  <message>
   <source>a text needs two straight quotation marks on one line</source>
   <translation>ein Text braucht zwei gerade Anführungszeichen in einer Zeile</translation>
  </message>
  <message>
   <source>a value of type {0}</source>
   <translation>ein Wert vom Typ {0}</translation>
  </message>
  <message>
   <source>a whole number of more than 40 digits</source>
   <translation>eine ganze Zahl mit über 40 Ziffern</translation>
  </message>
  <message>
   <source>a word needs straight quotation marks; write “{0} = "{1}"”</source>
   <translation>ein Wort braucht gerade Anführungszeichen; schreiben Sie „{0} = "{1}"“</translation>
  </message>
  <message>
   <source>a {0} flank reaches into the root; the variant is too inaccurate for this design to make a tooth of</source>
   <translation>eine Flanke ({0}) reicht in den Fuß; die Variante ist für diesen Entwurf zu ungenau für einen Zahn</translation>
  </message>
  <message>
   <source>addendum and dedendum angles of {0} leave {1} of the mean depth at an end of the face, less than {2}; use smaller ones, the standard taper or a smaller face width</source>
   <translation>Kopf- und Fußwinkel von {0} lassen an einem Ende der Breite {1} der mittleren Höhe, weniger als {2}; kleinere Winkel, die Standardverjüngung oder kleinere Zahnbreite nehmen</translation>
  </message>
  <message>
   <source>an archive (ZIP), as 3MF models and office documents are</source>
   <translation>ein Archiv (ZIP), wie es 3MF-Modelle und Office-Dokumente sind</translation>
  </message>
  <message>
   <source>an offset of {0} mm admits no pitch cones for these teeth, spiral angle and cutter</source>
   <translation>ein Achsversatz von {0} mm lässt für diese Zähne, Spiralwinkel und Messerkopf keine Teilkegel zu</translation>
  </message>
  <message>
   <source>an offset of {0} mm leaves the pinion no face and root cone</source>
   <translation>ein Achsversatz von {0} mm lässt dem Ritzel keinen Kopf- und Fußkegel</translation>
  </message>
  <message>
   <source>another program is using it</source>
   <translation>ein anderes Programm benutzt sie gerade</translation>
  </message>
  <message>
   <source>another tooth depth or more teeth</source>
   <translation>eine andere Zahnhöhe oder mehr Zähne</translation>
  </message>
  <message>
   <source>ask who owns it to let you read it</source>
   <translation>bitten Sie den Eigentümer um das Recht, sie zu lesen</translation>
  </message>
  <message>
   <source>base angle {0} rad is outside (0, pi/2)</source>
   <translation>Grundkegelwinkel {0} rad liegt außerhalb (0, pi/2)</translation>
  </message>
  <message>
   <source>best fit</source>
   <translation>beste Einpassung</translation>
  </message>
  <message>
   <source>body {0}</source>
   <translation>Radkörper {0}</translation>
  </message>
  <message>
   <source>building</source>
   <translation>wird gebaut</translation>
  </message>
  <message>
   <source>building {0}, {1}, {2}</source>
   <translation>{0}, {1}, {2} wird gebaut</translation>
  </message>
  <message>
   <source>check its name, it may have been moved</source>
   <translation>prüfen Sie den Namen, vielleicht wurde sie verschoben</translation>
  </message>
  <message>
   <source>checking</source>
   <translation>wird geprüft</translation>
  </message>
  <message>
   <source>choose a file in it</source>
   <translation>wählen Sie eine Datei darin</translation>
  </message>
  <message>
   <source>choose a file that GearStudio saved, NAME.gear.toml</source>
   <translation>wählen Sie eine Datei, die GearStudio gespeichert hat, NAME.gear.toml</translation>
  </message>
  <message>
   <source>choose a shorter one</source>
   <translation>wählen Sie einen kürzeren</translation>
  </message>
  <message>
   <source>choose another disk</source>
   <translation>wählen Sie einen anderen Datenträger</translation>
  </message>
  <message>
   <source>choose another disk, and have this one checked</source>
   <translation>wählen Sie einen anderen Datenträger und lassen Sie diesen prüfen</translation>
  </message>
  <message>
   <source>choose another folder</source>
   <translation>wählen Sie einen anderen Ordner</translation>
  </message>
  <message>
   <source>choose another folder, or ask who owns this one</source>
   <translation>wählen Sie einen anderen Ordner oder fragen Sie, wem dieser gehört</translation>
  </message>
  <message>
   <source>choose another folder, or make this one first</source>
   <translation>wählen Sie einen anderen Ordner oder legen Sie diesen zuerst an</translation>
  </message>
  <message>
   <source>choose another name</source>
   <translation>wählen Sie einen anderen Namen</translation>
  </message>
  <message>
   <source>choosing faces</source>
   <translation>Flächen werden gewählt</translation>
  </message>
  <message>
   <source>close it there and try again</source>
   <translation>schließen Sie sie dort und versuchen Sie es noch einmal</translation>
  </message>
  <message>
   <source>closed valid </source>
   <translation>geschlossene gültige </translation>
  </message>
  <message>
   <source>collecting the gear</source>
   <translation>Rad wird zusammengestellt</translation>
  </message>
  <message>
   <source>contact on the {0}'s {1} flank starts below its root cone</source>
   <translation>Kontakt am {0} auf der Flanke ({1}) beginnt unter dem Fußkegel</translation>
  </message>
  <message>
   <source>continuing the flanks</source>
   <translation>Flanken werden fortgesetzt</translation>
  </message>
  <message>
   <source>convergence</source>
   <translation>Konvergenz</translation>
  </message>
  <message>
   <source>copy the file from another place, and have this disk checked</source>
   <translation>holen Sie die Datei von anderswo und lassen Sie diesen Datenträger prüfen</translation>
  </message>
  <message>
   <source>cutting of the {0}</source>
   <translation>Schneiden: {0}</translation>
  </message>
  <message>
   <source>cutting the tooth spaces left {0} solids instead of one</source>
   <translation>das Schneiden der Zahnlücken ließ {0} Körper statt einem</translation>
  </message>
  <message>
   <source>cutting tooth spaces {0} to {1} of {2}</source>
   <translation>Zahnlücken {0} bis {1} von {2} werden geschnitten</translation>
  </message>
  <message>
   <source>does not reach everywhere: {0}</source>
   <translation>reicht nicht überallhin: {0}</translation>
  </message>
  <message>
   <source>drawing {0}</source>
   <translation>{0} wird gezeichnet</translation>
  </message>
  <message>
   <source>face angle {0}° and root angle {1}° of the wheel must lie between 0° and 90°; use smaller addendum and dedendum angles or the uniform taper</source>
   <translation>Kopfkegelwinkel {0}° und Fußkegelwinkel {1}° des Rads müssen zwischen 0° und 90° liegen; kleinere Kopf- und Fußwinkel oder gleich hohe Zähne nehmen</translation>
  </message>
  <message>
   <source>face {0} is not valid after reading back</source>
   <translation>Fläche {0} ist nach dem Zurücklesen ungültig</translation>
  </message>
  <message>
   <source>films are written as .mp4 or .gif</source>
   <translation>Filme werden als .mp4 oder .gif geschrieben</translation>
  </message>
  <message>
   <source>free some space, or choose another disk</source>
   <translation>schaffen Sie Platz oder wählen Sie einen anderen Datenträger</translation>
  </message>
  <message>
   <source>geometry data sheet</source>
   <translation>Datenblatt der Geometrie</translation>
  </message>
  <message>
   <source>give the pair deeper teeth or a larger overlap</source>
   <translation>dem Paar höhere Zähne oder größere Überdeckung geben</translation>
  </message>
  <message>
   <source>has nothing to mesh with at an end, where the wheel's tips lie inside its base cone</source>
   <translation>hat an einem Ende nichts zum Kämmen, weil der Kopf des Rads in dessen Grundkegel liegt</translation>
  </message>
  <message>
   <source>heel chamfer</source>
   <translation>Fase an der Ferse</translation>
  </message>
  <message>
   <source>heel end</source>
   <translation>Ende an der Ferse</translation>
  </message>
  <message>
   <source>instead of {0} µm at most</source>
   <translation>statt höchstens {0} µm</translation>
  </message>
  <message>
   <source>internal error: {0}</source>
   <translation>innerer Fehler: {0}</translation>
  </message>
  <message>
   <source>is a folder</source>
   <translation>ist ein Ordner</translation>
  </message>
  <message>
   <source>is undercut near the {0}, {1} mm from the pitch apex, polar angle {2}° (area ratio {3}, must exceed {4})</source>
   <translation>ist unterschnitten bei {0}, {1} mm von der Teilkegelspitze, Polarwinkel {2}° (Flächenverhältnis {3}, muss über {4} liegen)</translation>
  </message>
  <message>
   <source>it cannot be read from line {0} on; compare it with a design that GearStudio saved</source>
   <translation>sie ist ab Zeile {0} nicht lesbar; vergleichen Sie sie mit einem Entwurf, den GearStudio gespeichert hat</translation>
  </message>
  <message>
   <source>it cannot be read to its end; compare it with a design that GearStudio saved</source>
   <translation>sie ist nicht bis zum Ende lesbar; vergleichen Sie sie mit einem Entwurf, den GearStudio gespeichert hat</translation>
  </message>
  <message>
   <source>it ended with exit status {0}</source>
   <translation>er endete mit dem Status {0}</translation>
  </message>
  <message>
   <source>it failed to start {0} times; {1}</source>
   <translation>Start {0}-mal misslungen; {1}</translation>
  </message>
  <message>
   <source>it holds something that is not a number</source>
   <translation>sie enthält etwas, das keine Zahl ist</translation>
  </message>
  <message>
   <source>it is a model of another gear, or its axis is not the z axis</source>
   <translation>es ist das Modell eines anderen Rads, oder seine Achse ist nicht die z-Achse</translation>
  </message>
  <message>
   <source>it stopped answering</source>
   <translation>er antwortete nicht mehr</translation>
  </message>
  <message>
   <source>it was killed by {0}</source>
   <translation>er wurde durch {0} beendet</translation>
  </message>
  <message>
   <source>it was made of another state of the design: {0} changed since</source>
   <translation>aus einem anderen Stand des Entwurfs gemacht: {0} seitdem geändert</translation>
  </message>
  <message>
   <source>its result could not be read: {0}</source>
   <translation>Ergebnis nicht lesbar: {0}</translation>
  </message>
  <message>
   <source>joining the faces</source>
   <translation>Flächen werden verbunden</translation>
  </message>
  <message>
   <source>leaves the tip of its teeth {0} mm wide at the heel, less than {1} mm: they are pointed</source>
   <translation>lässt den Zahnkopf an der Ferse {0} mm breit, weniger als {1} mm: die Zähne sind spitz</translation>
  </message>
  <message>
   <source>leaves the {0} no tooth space at the foot of the flanks</source>
   <translation>lässt am {0} keine Zahnlücke am Fuß der Flanken</translation>
  </message>
  <message>
   <source>leaves {0} mm of the tooth space at the foot of the flanks, less than {1} mm</source>
   <translation>lässt {0} mm der Zahnlücke am Fuß der Flanken, weniger als {1} mm</translation>
  </message>
  <message>
   <source>left out</source>
   <translation>weggelassen</translation>
  </message>
  <message>
   <source>less than {0}</source>
   <translation>weniger als {0}</translation>
  </message>
  <message>
   <source>lies {0} µm from theory instead of at most {1} µm</source>
   <translation>liegt {0} µm von der Theorie statt höchstens {1} µm</translation>
  </message>
  <message>
   <source>line {0} has {1} columns, where {2} or more are needed</source>
   <translation>Zeile {0} hat {1} Spalten, {2} oder mehr sind nötig</translation>
  </message>
  <message>
   <source>line {0} has {1} column{2}; give x, y, z or x, y, z, nx, ny, nz, or name the columns in a header line</source>
   <translation>Zeile {0} hat {1} Spalte(n); x, y, z oder x, y, z, nx, ny, nz angeben, oder die Spalten in einer Kopfzeile benennen</translation>
  </message>
  <message>
   <source>line {0} is not UTF-8 text; save the file as UTF-8 in your editor</source>
   <translation>Zeile {0} ist kein UTF-8-Text; speichern Sie die Datei in Ihrem Editor als UTF-8</translation>
  </message>
  <message>
   <source>line {0}, “{1}”: {2}</source>
   <translation>Zeile {0}, „{1}“: {2}</translation>
  </message>
  <message>
   <source>line {0}: {1} is not a finite number</source>
   <translation>Zeile {0}: {1} ist keine endliche Zahl</translation>
  </message>
  <message>
   <source>line {0}: {1} is not a number</source>
   <translation>Zeile {0}: {1} ist keine Zahl</translation>
  </message>
  <message>
   <source>lower side</source>
   <translation>Unterseite</translation>
  </message>
  <message>
   <source>makes its micro-geometry rise by up to {0} µm per mm of the flank, more than {1}</source>
   <translation>lässt die Mikrogeometrie um bis zu {0} µm je mm der Flanke steigen, mehr als {1}</translation>
  </message>
  <message>
   <source>makes the {0}'s teeth pointed</source>
   <translation>macht die Zähne am {0} spitz</translation>
  </message>
  <message>
   <source>measuring the gaps</source>
   <translation>Spalte werden gemessen</translation>
  </message>
  <message>
   <source>meets the wheel inside its base cone with its tips</source>
   <translation>trifft das Rad mit den Köpfen in dessen Grundkegel</translation>
  </message>
  <message>
   <source>meshing of the {0}</source>
   <translation>Vernetzung: {0}</translation>
  </message>
  <message>
   <source>more pinion teeth, a larger spiral angle or shallower teeth</source>
   <translation>mehr Ritzelzähne, größeren Spiralwinkel oder niedrigere Zähne</translation>
  </message>
  <message>
   <source>more teeth</source>
   <translation>mehr Zähne</translation>
  </message>
  <message>
   <source>more than {0}</source>
   <translation>mehr als {0}</translation>
  </message>
  <message>
   <source>more than {0}, up to {1}</source>
   <translation>mehr als {0}, bis {1}</translation>
  </message>
  <message>
   <source>no construction {0}; use {1}</source>
   <translation>kein Aufbau {0}; {1} nehmen</translation>
  </message>
  <message>
   <source>no contact: at some turn no tooth of the pinion faces a flank of the wheel; {0}</source>
   <translation>kein Kontakt: in einer Stellung steht kein Ritzelzahn einer Flanke des Rads gegenüber; {0}</translation>
  </message>
  <message>
   <source>no fillet of {0} mm joins root and start of contact on the {1}'s {2} flank</source>
   <translation>keine Fußrundung von {0} mm verbindet Fuß und Eingriffsbeginn an der Flanke {2} ({1})</translation>
  </message>
  <message>
   <source>no known format; use {0}</source>
   <translation>kein bekanntes Format; {0} nehmen</translation>
  </message>
  <message>
   <source>no permission</source>
   <translation>keine Erlaubnis</translation>
  </message>
  <message>
   <source>no radius does with this spiral angle; use a spiral angle of at most {0}°</source>
   <translation>bei diesem Spiralwinkel passt kein Radius; einen Spiralwinkel von höchstens {0}° nehmen</translation>
  </message>
  <message>
   <source>no radius does: use a narrower face width or a smaller spiral angle</source>
   <translation>kein Radius passt: kleinere Zahnbreite oder kleineren Spiralwinkel nehmen</translation>
  </message>
  <message>
   <source>no such preset; the nearest is {0}{1}; presets: {2}</source>
   <translation>keine solche Vorlage; die nächste ist {0}{1}; Vorlagen: {2}</translation>
  </message>
  <message>
   <source>none of the {0} faces is a flank of this {1}; {2}</source>
   <translation>keine der {0} Flächen ist eine Flanke vom {1}; {2}</translation>
  </message>
  <message>
   <source>nothing in it belongs to a design of GearStudio; {0}</source>
   <translation>nichts darin gehört zu einem Entwurf von GearStudio; {0}</translation>
  </message>
  <message>
   <source>numbers in a design file have a point, not a comma; write “{0} = {1}.{2}”</source>
   <translation>Zahlen in einer Entwurfsdatei haben einen Punkt, kein Komma; schreiben Sie „{0} = {1}.{2}“</translation>
  </message>
  <message>
   <source>of a pair only the part 'gear' is written, not {0}</source>
   <translation>von einem Paar wird nur der Teil 'gear' geschrieben, nicht {0}</translation>
  </message>
  <message>
   <source>one line of up to {0} characters</source>
   <translation>eine Zeile mit bis zu {0} Zeichen</translation>
  </message>
  <message>
   <source>pictures are written as .png or .jpg</source>
   <translation>Bilder werden als .png oder .jpg geschrieben</translation>
  </message>
  <message>
   <source>pipe along the tooth trace</source>
   <translation>Rohr entlang der Flankenlinie</translation>
  </message>
  <message>
   <source>placing the tooth spaces</source>
   <translation>Zahnlücken werden platziert</translation>
  </message>
  <message>
   <source>points along each side</source>
   <translation>Punkte je Seite</translation>
  </message>
  <message>
   <source>points of the wheel's flank never touch the pinion</source>
   <translation>Punkte der Radflanke berühren das Ritzel nie</translation>
  </message>
  <message>
   <source>points {0} mm apart are too many; use {1} mm or more</source>
   <translation>Punkte im Abstand {0} mm sind zu viele; {1} mm oder mehr nehmen</translation>
  </message>
  <message>
   <source>polar angle lies inside the base cone: the involute does not exist there</source>
   <translation>der Polarwinkel liegt im Grundkegel: dort gibt es die Evolvente nicht</translation>
  </message>
  <message>
   <source>psi, trace</source>
   <translation>psi, Linie</translation>
  </message>
  <message>
   <source>reading</source>
   <translation>wird gelesen</translation>
  </message>
  <message>
   <source>recovery format {0} is not the {1} that this program reads</source>
   <translation>Wiederherstellungsformat {0} ist nicht {1}, das dieses Programm liest</translation>
  </message>
  <message>
   <source>setting the pages</source>
   <translation>Seiten werden gesetzt</translation>
  </message>
  <message>
   <source>smaller amounts on both flanks of this member</source>
   <translation>kleinere Beträge auf beiden Flanken dieses Rads</translation>
  </message>
  <message>
   <source>smaller modifications, or other depths</source>
   <translation>kleinere Modifikationen oder andere Zahnhöhen</translation>
  </message>
  <message>
   <source>some are flanks of a gear of the other hand</source>
   <translation>einige sind Flanken eines Rads mit anderer Spiralrichtung</translation>
  </message>
  <message>
   <source>some are flanks of the {0}</source>
   <translation>einige sind Flanken vom {0}</translation>
  </message>
  <message>
   <source>some are in {0}: give the file the right unit</source>
   <translation>einige sind in {0}: der Datei die richtige Einheit geben</translation>
  </message>
  <message>
   <source>studying {0}, {1}</source>
   <translation>{0}, {1} wird untersucht</translation>
  </message>
  <message>
   <source>tables or lists in it are nested too deeply for a design</source>
   <translation>Tabellen oder Listen darin sind für einen Entwurf zu tief geschachtelt</translation>
  </message>
  <message>
   <source>take less misalignment</source>
   <translation>kleinere Einbaufehler nehmen</translation>
  </message>
  <message>
   <source>taking points</source>
   <translation>Punkte werden genommen</translation>
  </message>
  <message>
   <source>taking points of {0}</source>
   <translation>Punkte von {0} werden genommen</translation>
  </message>
  <message>
   <source>the CAD kernel cannot read this as STEP</source>
   <translation>der CAD-Kern kann dies nicht als STEP lesen</translation>
  </message>
  <message>
   <source>the CAD kernel cannot read this as {0}; it may be cut off or damaged</source>
   <translation>der CAD-Kern kann dies nicht als {0} lesen; es ist vielleicht abgeschnitten oder beschädigt</translation>
  </message>
  <message>
   <source>the CAD kernel could not write the {0} file and gave no reason; try another format or folder</source>
   <translation>der CAD-Kern konnte die {0}-Datei nicht schreiben und nannte keinen Grund; versuchen Sie ein anderes Format oder einen anderen Ordner</translation>
  </message>
  <message>
   <source>the CAD kernel made no face of the surface ({0})</source>
   <translation>der CAD-Kern machte aus der Fläche kein Face ({0})</translation>
  </message>
  <message>
   <source>the arc of {0} mm does not cross {1} from {2} to {3} mm at less than {4}°; {5}</source>
   <translation>der Bogen von {0} mm überquert {1} von {2} bis {3} mm nicht unter {4}°; {5}</translation>
  </message>
  <message>
   <source>the conjugate flank has no point where one was asked for; it is undercut or too short there</source>
   <translation>die konjugierte Flanke hat am gefragten Ort keinen Punkt; sie ist dort unterschnitten oder zu kurz</translation>
  </message>
  <message>
   <source>the disk is full</source>
   <translation>die Platte ist voll</translation>
  </message>
  <message>
   <source>the disk is read-only</source>
   <translation>die Platte ist schreibgeschützt</translation>
  </message>
  <message>
   <source>the disk quota is used up</source>
   <translation>das Plattenkontingent ist verbraucht</translation>
  </message>
  <message>
   <source>the disk reports a fault</source>
   <translation>die Platte meldet einen Fehler</translation>
  </message>
  <message>
   <source>the edge of a chamfer at the end of the teeth could not be followed</source>
   <translation>der Kante einer Endfase konnte nicht gefolgt werden</translation>
  </message>
  <message>
   <source>the file is empty and holds no design; {0}, or an earlier copy of it</source>
   <translation>die Datei ist leer und enthält keinen Entwurf; {0}, oder eine frühere Kopie</translation>
  </message>
  <message>
   <source>the file is gone; its record is still there</source>
   <translation>die Datei ist fort; ihr Prüfbericht ist noch da</translation>
  </message>
  <message>
   <source>the file is not as it was written: its checksum is another</source>
   <translation>die Datei ist nicht wie geschrieben: ihre Prüfsumme ist eine andere</translation>
  </message>
  <message>
   <source>the file is too large for this disk</source>
   <translation>die Datei ist zu groß für diese Platte</translation>
  </message>
  <message>
   <source>the fillet of a hypoid tooth could not be found</source>
   <translation>die Fußrundung eines Hypoidzahns wurde nicht gefunden</translation>
  </message>
  <message>
   <source>the fillets of neighbouring {0} teeth overlap, however small they are</source>
   <translation>die Fußrundungen benachbarter Zähne überschneiden sich ({0}), so klein sie auch sind</translation>
  </message>
  <message>
   <source>the film could not be encoded; try a smaller picture, or the other kind of file</source>
   <translation>der Film konnte nicht kodiert werden; versuchen Sie ein kleineres Bild oder die andere Art von Datei</translation>
  </message>
  <message>
   <source>the flank is undercut below the start of contact</source>
   <translation>die Flanke ist unter dem Kontaktbeginn unterschnitten</translation>
  </message>
  <message>
   <source>the flank's curvature is infinite on the base cone; take points above it</source>
   <translation>die Krümmung der Flanke ist auf dem Grundkegel unendlich; Punkte darüber nehmen</translation>
  </message>
  <message>
   <source>the flanks of neighbouring {0} teeth meet above the root cone</source>
   <translation>die Flanken benachbarter Zähne am {0} treffen sich über dem Fußkegel</translation>
  </message>
  <message>
   <source>the flanks' normal pressure angles would be {0}° and {1}°, outside 0° to 45°; use a factor of at most {2}</source>
   <translation>die Normaleingriffswinkel der Flanken wären {0}° und {1}°, außerhalb 0° bis 45°; einen Faktor von höchstens {2} nehmen</translation>
  </message>
  <message>
   <source>the gear's axis lies along {0}, turn it to +z</source>
   <translation>die Radachse liegt entlang {0}, nach +z drehen</translation>
  </message>
  <message>
   <source>the header names no column {0}; it needs x, y and z</source>
   <translation>die Kopfzeile nennt keine Spalte {0}; x, y und z sind nötig</translation>
  </message>
  <message>
   <source>the header says {0}; convert the points to mm</source>
   <translation>die Kopfzeile sagt {0}; die Punkte in mm umrechnen</translation>
  </message>
  <message>
   <source>the heading of a table stands alone on its line and between brackets, as “[pair]”</source>
   <translation>die Überschrift einer Tabelle steht allein in ihrer Zeile und in eckigen Klammern, wie „[pair]“</translation>
  </message>
  <message>
   <source>the heel</source>
   <translation>die Ferse</translation>
  </message>
  <message>
   <source>the job could not be sent: {0}: {1}</source>
   <translation>der Auftrag konnte nicht gesendet werden: {0}: {1}</translation>
  </message>
  <message>
   <source>the kernel could not cut the tooth spaces from the blank</source>
   <translation>der Kern konnte die Zahnlücken nicht aus dem Rohling schneiden</translation>
  </message>
  <message>
   <source>the kernel's interpolation of the points failed</source>
   <translation>die Interpolation der Punkte durch den Kern misslang</translation>
  </message>
  <message>
   <source>the kernel's {0} failed: {1}</source>
   <translation>Kern, {0}: misslungen: {1}</translation>
  </message>
  <message>
   <source>the kernel's {0} gave {1} faces where one was expected</source>
   <translation>Kern, {0}: {1} Flächen, wo eine erwartet war</translation>
  </message>
  <message>
   <source>the name is too long</source>
   <translation>der Name ist zu lang</translation>
  </message>
  <message>
   <source>the number of the format is missing; write format = {0} in the first line</source>
   <translation>die Nummer des Formats fehlt; schreiben Sie format = {0} in die erste Zeile</translation>
  </message>
  <message>
   <source>the order of convergence takes three constructions or more</source>
   <translation>die Konvergenzordnung braucht drei oder mehr Aufbauten</translation>
  </message>
  <message>
   <source>the part {0} is not offered; parts: {1}</source>
   <translation>der Teil {0} wird nicht angeboten; Teile: {1}</translation>
  </message>
  <message>
   <source>the points are {0} mm rms from this {1}'s flanks as they lie; they fit when the best fit may turn and shift the part</source>
   <translation>die Punkte liegen so {0} mm rms von den Flanken am {1}; sie passen, wenn die Einpassung drehen und schieben darf</translation>
  </message>
  <message>
   <source>the points do not lie on this {0}'s flanks: {1} mm rms are left after the best fit{2}; {3}</source>
   <translation>die Punkte liegen nicht auf den Flanken vom {0}: nach der Einpassung bleiben {1} mm rms{2}; {3}</translation>
  </message>
  <message>
   <source>the points do not tell turning and shifting apart; measure more of the flanks or fix one of the two</source>
   <translation>die Punkte unterscheiden Drehen und Schieben nicht; mehr von den Flanken messen oder eines festhalten</translation>
  </message>
  <message>
   <source>the points fit this {0} badly: {1} µm rms are left after the best fit, and no single number of the design explains them. Check that the part is of this design, and all points of its flanks</source>
   <translation>die Punkte passen schlecht zu diesem {0}: {1} µm (quadratisches Mittel) bleiben nach der besten Einpassung, und keine einzelne Zahl des Entwurfs erklärt sie. Prüfen Sie, ob das Teil zu diesem Entwurf gehört und alle Punkte auf seinen Flanken liegen</translation>
  </message>
  <message>
   <source>the points fit this {0} badly: {1} µm rms are left after the best fit; {2}. Check that the part is of this design, or give the design the value that it was made with</source>
   <translation>die Punkte passen schlecht zu diesem {0}: {1} µm (quadratisches Mittel) bleiben nach der besten Einpassung; {2}. Prüfen Sie, ob das Teil zu diesem Entwurf gehört, oder geben Sie dem Entwurf den Wert, mit dem es gefertigt wurde</translation>
  </message>
  <message>
   <source>the points look as if they were in {0}: multiplied by {1} they lie on the {2}'s teeth; convert them to mm</source>
   <translation>die Punkte sehen aus wie in {0}: mal {1} liegen sie auf den Zähnen vom {2}; in mm umrechnen</translation>
  </message>
  <message>
   <source>the recursion of ISO 23509 Method 1 finds no pitch cones for this pair</source>
   <translation>die Rekursion von ISO 23509 Methode 1 findet für dieses Paar keine Teilkegel</translation>
  </message>
  <message>
   <source>the root of the pinion</source>
   <translation>dem Fuß des Ritzels</translation>
  </message>
  <message>
   <source>the root of the wheel</source>
   <translation>dem Fuß des Rads</translation>
  </message>
  <message>
   <source>the solid is not closed</source>
   <translation>der Körper ist nicht geschlossen</translation>
  </message>
  <message>
   <source>the solid is not valid</source>
   <translation>der Körper ist ungültig</translation>
  </message>
  <message>
   <source>the standard taper</source>
   <translation>die Standardverjüngung</translation>
  </message>
  <message>
   <source>the start of contact does not reach over the pinion's whole face; the pair is undercut there</source>
   <translation>der Kontaktbeginn reicht nicht über die ganze Ritzelbreite; das Paar ist dort unterschnitten</translation>
  </message>
  <message>
   <source>the surface has no tangent plane somewhere; it is folded or starts on the base cone</source>
   <translation>die Fläche hat irgendwo keine Tangentialebene; sie ist gefaltet oder beginnt auf dem Grundkegel</translation>
  </message>
  <message>
   <source>the teeth up to their heel corners</source>
   <translation>die Zähne bis zu ihren Fersenecken</translation>
  </message>
  <message>
   <source>the text is not UTF-8 but UTF-16; save the file as UTF-8 in your editor</source>
   <translation>der Text ist nicht UTF-8, sondern UTF-16; speichern Sie die Datei in Ihrem Editor als UTF-8</translation>
  </message>
  <message>
   <source>the tilted root line</source>
   <translation>die geneigte Fußlinie</translation>
  </message>
  <message>
   <source>the tip of the pinion</source>
   <translation>dem Kopf des Ritzels</translation>
  </message>
  <message>
   <source>the tip of the wheel</source>
   <translation>dem Kopf des Rads</translation>
  </message>
  <message>
   <source>the toe</source>
   <translation>der Zehe</translation>
  </message>
  <message>
   <source>the value after the sign = is missing; put it there, or take the line out to have the usual “{0}”</source>
   <translation>der Wert nach dem Zeichen = fehlt; setzen Sie ihn ein oder löschen Sie die Zeile, dann gilt „{0}“ wie üblich</translation>
  </message>
  <message>
   <source>the value is empty; {0}</source>
   <translation>der Wert ist leer; {0}</translation>
  </message>
  <message>
   <source>the value is neither a number, as “3.5”, nor a text between straight quotation marks</source>
   <translation>der Wert ist weder eine Zahl, wie „3.5“, noch ein Text in geraden Anführungszeichen</translation>
  </message>
  <message>
   <source>the volume differs by {0}</source>
   <translation>das Volumen weicht um {0} ab</translation>
  </message>
  <message>
   <source>the web's front face, {0} mm from the apex, must lie on the front cone between {1} and {2} mm; change the thickness by {3} mm</source>
   <translation>die Vorderfläche des Stegs, {0} mm von der Spitze, muss auf dem Vorderkegel zwischen {1} und {2} mm liegen; die Dicke um {3} mm ändern</translation>
  </message>
  <message>
   <source>the wheel's cone of {0}° leaves the pinion no cone to match; use smaller addendum and dedendum angles, the uniform taper or a smaller shaft angle</source>
   <translation>der Kegel des Rads von {0}° lässt dem Ritzel keinen passenden Kegel; kleinere Kopf- und Fußwinkel, gleich hohe Zähne oder kleineren Achsenwinkel nehmen</translation>
  </message>
  <message>
   <source>the whole face width</source>
   <translation>die ganze Zahnbreite</translation>
  </message>
  <message>
   <source>the {0} could not be fitted within {1} µm (got {2} µm)</source>
   <translation>{0} ließ sich nicht auf {1} µm annähern (erreicht {2} µm)</translation>
  </message>
  <message>
   <source>the {0} misses its limits by {1} mm and cannot be continued that far; the variant is too inaccurate for this design to make a tooth of</source>
   <translation>{0} verfehlt die Grenzen um {1} mm und lässt sich nicht so weit fortsetzen; die Variante ist für diesen Entwurf zu ungenau für einen Zahn</translation>
  </message>
  <message>
   <source>the {0} of a pair with {1}</source>
   <translation>das {0} eines Paars mit {1}</translation>
  </message>
  <message>
   <source>the {0}'s flanks are up to {1} µm from those of the design, which a rotating line cannot sweep; the faces are held against the flanks that it does sweep</source>
   <translation>die Flanken am {0} liegen bis {1} µm von denen des Entwurfs, die eine rollende Gerade nicht überstreicht; geprüft wird gegen die, die sie überstreicht</translation>
  </message>
  <message>
   <source>the {0}'s teeth are pointed below their face cone</source>
   <translation>die Zähne am {0} sind unter dem Kopfkegel spitz</translation>
  </message>
  <message>
   <source>the {0}'s {1} {2}</source>
   <translation>{0}, {1}: {2}</translation>
  </message>
  <message>
   <source>there are no faces in it; points can be taken from solids and surfaces only</source>
   <translation>es sind keine Flächen darin; Punkte gibt es nur von Körpern und Flächen</translation>
  </message>
  <message>
   <source>there are no points in it</source>
   <translation>es sind keine Punkte darin</translation>
  </message>
  <message>
   <source>there is a file where the folder should be</source>
   <translation>wo der Ordner sein sollte, ist eine Datei</translation>
  </message>
  <message>
   <source>there is a folder of this name</source>
   <translation>es gibt einen Ordner dieses Namens</translation>
  </message>
  <message>
   <source>there is no such file</source>
   <translation>diese Datei gibt es nicht</translation>
  </message>
  <message>
   <source>there is no such file or folder</source>
   <translation>diese Datei oder diesen Ordner gibt es nicht</translation>
  </message>
  <message>
   <source>these values make no gear: {0}</source>
   <translation>diese Werte ergeben kein Rad: {0}</translation>
  </message>
  <message>
   <source>they are of another gear (number of teeth, spiral angle, hand)</source>
   <translation>sie gehören zu einem anderen Rad (Zähnezahl, Spiralwinkel, Richtung)</translation>
  </message>
  <message>
   <source>they are of another gear, or the origin is not at the apex and z not along the axis</source>
   <translation>sie gehören zu einem anderen Rad, oder der Ursprung ist nicht in der Spitze und z nicht entlang der Achse</translation>
  </message>
  <message>
   <source>they fit a gear of the other hand</source>
   <translation>sie passen zu einem Rad mit anderer Spiralrichtung</translation>
  </message>
  <message>
   <source>they fit the {0}</source>
   <translation>sie passen zum {0}</translation>
  </message>
  <message>
   <source>they fit {0}: {1} mm rms are left</source>
   <translation>sie passen zu {0}: {1} mm rms bleiben</translation>
  </message>
  <message>
   <source>this is a device, not a file</source>
   <translation>dies ist ein Gerät, keine Datei</translation>
  </message>
  <message>
   <source>this is a folder, not a file</source>
   <translation>dies ist ein Ordner, keine Datei</translation>
  </message>
  <message>
   <source>this is no complete {0} file; it may be cut off or damaged</source>
   <translation>dies ist keine vollständige {0}-Datei; sie ist vielleicht abgeschnitten oder beschädigt</translation>
  </message>
  <message>
   <source>this is no heading of a table, as “[pair]”, no entry, as “pinion_teeth = 17”, and no comment after #</source>
   <translation>dies ist keine Überschrift einer Tabelle, wie „[pair]“, kein Eintrag, wie „pinion_teeth = 17“, und kein Kommentar nach #</translation>
  </message>
  <message>
   <source>this is no record of an export, or a damaged one; export again</source>
   <translation>dies ist kein Exportbericht oder ein beschädigter; neu exportieren</translation>
  </message>
  <message>
   <source>this is no recovery file of GearStudio ({0})</source>
   <translation>dies ist keine Wiederherstellungsdatei von GearStudio ({0})</translation>
  </message>
  <message>
   <source>this is no text, so no design of GearStudio; {0}</source>
   <translation>dies ist kein Text, also kein Entwurf von GearStudio; {0}</translation>
  </message>
  <message>
   <source>this is not a file name</source>
   <translation>dies ist kein Dateiname</translation>
  </message>
  <message>
   <source>this is not the {0} {1} of this design: what is in it fills {2} mm</source>
   <translation>dies ist nicht {0}, {1} aus diesem Entwurf: der Inhalt füllt {2} mm</translation>
  </message>
  <message>
   <source>this is {0}, no design of GearStudio; {1}</source>
   <translation>dies ist {0}, kein Entwurf von GearStudio; {1}</translation>
  </message>
  <message>
   <source>this misalignment takes {0} mm of backlash that the pair does not have: the teeth jam; give more backlash</source>
   <translation>dieser Einbaufehler braucht {0} mm Flankenspiel, das das Paar nicht hat: die Zähne klemmen; mehr Flankenspiel geben</translation>
  </message>
  <message>
   <source>toe chamfer</source>
   <translation>Fase an der Zehe</translation>
  </message>
  <message>
   <source>toe end</source>
   <translation>Ende an der Zehe</translation>
  </message>
  <message>
   <source>tooth contact</source>
   <translation>Zahnkontakt</translation>
  </message>
  <message>
   <source>tooth {0} {1}</source>
   <translation>Zahn {0} {1}</translation>
  </message>
  <message>
   <source>triangles lie {0} µm from the surfaces {1}</source>
   <translation>Dreiecke liegen {0} µm von den Flächen {1}</translation>
  </message>
  <message>
   <source>triangles within {0} mm and {1}° of the {2} would be more than {3} million; allow a larger distance or angle</source>
   <translation>Dreiecke innerhalb {0} mm und {1}° ({2}) wären über {3} Millionen; größeren Abstand oder Winkel zulassen</translation>
  </message>
  <message>
   <source>turning the blank</source>
   <translation>Rohling wird gedreht</translation>
  </message>
  <message>
   <source>unexpected error: {0}</source>
   <translation>unerwarteter Fehler: {0}</translation>
  </message>
  <message>
   <source>unknown key; the nearest known one is {0}</source>
   <translation>unbekannter Schlüssel; der nächste bekannte ist {0}</translation>
  </message>
  <message>
   <source>unknown spacing {0}; use one of {1}</source>
   <translation>unbekannter Abstand {0}; eines von {1} nehmen</translation>
  </message>
  <message>
   <source>use a larger clearance or shallower teeth</source>
   <translation>ein größeres Kopfspiel oder niedrigere Zähne verwenden</translation>
  </message>
  <message>
   <source>use a smaller clearance, or other depths that leave the teeth more space at the root</source>
   <translation>ein kleineres Kopfspiel verwenden, oder andere Zahnhöhen, die am Fuß mehr Platz lassen</translation>
  </message>
  <message>
   <source>use a smaller fillet factor or a larger clearance</source>
   <translation>kleineren Fußrundungsfaktor oder größeres Kopfspiel verwenden</translation>
  </message>
  <message>
   <source>use a smaller offset</source>
   <translation>kleineren Achsversatz nehmen</translation>
  </message>
  <message>
   <source>use a smaller offset or face width</source>
   <translation>kleineren Achsversatz oder kleinere Zahnbreite nehmen</translation>
  </message>
  <message>
   <source>use a spiral angle of at least {0}°</source>
   <translation>einen Spiralwinkel von mindestens {0}° nehmen</translation>
  </message>
  <message>
   <source>use at least {0} mm</source>
   <translation>mindestens {0} mm nehmen</translation>
  </message>
  <message>
   <source>use at most {0} mm</source>
   <translation>höchstens {0} mm nehmen</translation>
  </message>
  <message>
   <source>use {0}</source>
   <translation>{0} nehmen</translation>
  </message>
  <message>
   <source>waiting for pictures</source>
   <translation>warten auf Bilder</translation>
  </message>
  <message>
   <source>weighing</source>
   <translation>wird gewogen</translation>
  </message>
  <message>
   <source>whole number</source>
   <translation>ganze Zahl</translation>
  </message>
  <message>
   <source>with an offset each member has a transverse pressure angle of its own; give the normal one</source>
   <translation>mit Achsversatz hat jedes Rad einen eigenen Stirneingriffswinkel; den normalen angeben</translation>
  </message>
  <message>
   <source>with an offset the spiral angle is given at the mean point; use mean</source>
   <translation>mit Achsversatz gilt der Spiralwinkel im Mittelpunkt; Mitte wählen</translation>
  </message>
  <message>
   <source>with {0} instead of {1} it would be {2} µm</source>
   <translation>mit {0} statt {1} wären es {2} µm</translation>
  </message>
  <message>
   <source>writing {0}</source>
   <translation>{0} wird geschrieben</translation>
  </message>
  <message>
   <source>{0} MB is too large for a design file; the most is 1 MB</source>
   <translation>{0} MB sind zu viel für eine Entwurfsdatei; höchstens 1 MB</translation>
  </message>
  <message>
   <source>{0} after reading the file back</source>
   <translation>{0} nach dem Zurücklesen der Datei</translation>
  </message>
  <message>
   <source>{0} asks for fillets of {1} mm on the {2}, which do not fit between its flanks and its root; they get {3} mm, as with a fillet factor of {4}</source>
   <translation>{0} verlangt Fußrundungen von {1} mm ({2}), die zwischen Flanken und Fuß nicht passen; sie bekommen {3} mm, wie mit einem Fußrundungsfaktor von {4}</translation>
  </message>
  <message>
   <source>{0} cannot be a {1}; {2}</source>
   <translation>{0} kann kein Wert sein für {1}; {2}</translation>
  </message>
  <message>
   <source>{0} cannot be written as {1}; formats: {2}</source>
   <translation>{0} kann nicht als {1} geschrieben werden; Formate: {2}</translation>
  </message>
  <message>
   <source>{0} is a text; {1}, with a point and without quotation marks</source>
   <translation>{0} ist ein Text; {1}, mit einem Punkt und ohne Anführungszeichen</translation>
  </message>
  <message>
   <source>{0} is above the most of {1}{2}; {3}</source>
   <translation>{0} liegt über dem Höchstwert {1}{2}; {3}</translation>
  </message>
  <message>
   <source>{0} is below the least of {1}{2}; {3}</source>
   <translation>{0} liegt unter dem Mindestwert {1}{2}; {3}</translation>
  </message>
  <message>
   <source>{0} is more than the wheel's {1} teeth; the pinion is the member with fewer: exchange them</source>
   <translation>{0} ist mehr als die {1} Zähne des Rads; das Ritzel hat weniger Zähne: beide tauschen</translation>
  </message>
  <message>
   <source>{0} is newer than format {1}, which this GearStudio reads; update GearStudio to open the file, in which nothing was changed</source>
   <translation>{0} ist neuer als Format {1}, das dieses GearStudio liest; aktualisieren Sie GearStudio, um die Datei zu öffnen. Sie wurde nicht verändert</translation>
  </message>
  <message>
   <source>{0} is not a design; a design is a table of keys</source>
   <translation>{0} ist kein Entwurf; ein Entwurf ist eine Tabelle von Schlüsseln</translation>
  </message>
  <message>
   <source>{0} is not a finite number; {1}</source>
   <translation>{0} ist keine endliche Zahl; {1}</translation>
  </message>
  <message>
   <source>{0} is not a format number; write format = {1}</source>
   <translation>{0} ist keine Formatnummer; format = {1} schreiben</translation>
  </message>
  <message>
   <source>{0} is not a table; write [{1}] and its keys below it</source>
   <translation>{0} ist keine Tabelle; [{1}] und darunter die Schlüssel schreiben</translation>
  </message>
  <message>
   <source>{0} is not a whole number; {1}</source>
   <translation>{0} ist keine ganze Zahl; {1}</translation>
  </message>
  <message>
   <source>{0} is not a {1}; {2}</source>
   <translation>{0} ist keine {1}; {2}</translation>
  </message>
  <message>
   <source>{0} is not above {1}{2}; {3}</source>
   <translation>{0} liegt nicht über {1}{2}; {3}</translation>
  </message>
  <message>
   <source>{0} is not one of the choices; {1}</source>
   <translation>{0} gehört nicht zur Auswahl; {1}</translation>
  </message>
  <message>
   <source>{0} is too narrow to make a tooth; use at least {1}</source>
   <translation>{0} ist zu schmal für einen Zahn; mindestens {1} nehmen</translation>
  </message>
  <message>
   <source>{0} is unknown; this GearStudio reads format {1}</source>
   <translation>{0} ist unbekannt; dieses GearStudio liest Format {1}</translation>
  </message>
  <message>
   <source>{0} leaves a member no addendum at the mean point; use a smaller profile shift or a larger addendum factor</source>
   <translation>{0} lässt einem Rad im Mittelpunkt keine Kopfhöhe; kleinere Profilverschiebung oder größeren Kopfhöhenfaktor nehmen</translation>
  </message>
  <message>
   <source>{0} leaves the {1} no root: {2}; use {3}</source>
   <translation>{0} lässt keinen Zahnfuß ({1}): {2}; {3} nehmen</translation>
  </message>
  <message>
   <source>{0} leaves the {1} no root: {2}; {3}</source>
   <translation>{0} lässt keinen Zahnfuß ({1}): {2}; {3}</translation>
  </message>
  <message>
   <source>{0} leaves the {1} no {2} ({3} mm): its teeth do not reach across the pitch cone; use {4}</source>
   <translation>{0} lässt am {1} keine {2} ({3} mm): die Zähne reichen nicht über den Teilkegel; {4} nehmen</translation>
  </message>
  <message>
   <source>{0} leaves the {1}'s teeth no thickness at the pitch cone; use {2}</source>
   <translation>{0} lässt den Zähnen am {1} keine Dicke auf dem Teilkegel; {2} nehmen</translation>
  </message>
  <message>
   <source>{0} lets the {1}'s fillet reach into the flank that meets the mate's tip; use {2}</source>
   <translation>{0} lässt die Fußrundung am {1} in die Flanke reichen, die den Kopf des Gegenrads trifft; {2} nehmen</translation>
  </message>
  <message>
   <source>{0} lets the {1}'s tip reach below the {2}'s base cone, where no conjugate flank is: the teeth interfere there; use {3}</source>
   <translation>{0} lässt den Kopf am {1} unter den Grundkegel am {2} reichen, wo es keine konjugierte Flanke gibt: die Zähne stören sich dort; {3} nehmen</translation>
  </message>
  <message>
   <source>{0} makes no conjugate pinion: its {1}; use {2}</source>
   <translation>{0} gibt kein konjugiertes Ritzel: {1}; {2} nehmen</translation>
  </message>
  <message>
   <source>{0} makes the contact ratio only {1}: a pair of teeth parts before the next one meets; a larger addendum factor, spiral angle or face width raises it</source>
   <translation>{0} macht die Überdeckung nur {1}: ein Zahnpaar trennt sich, ehe das nächste greift; größerer Kopfhöhenfaktor, Spiralwinkel oder Zahnbreite hebt sie</translation>
  </message>
  <message>
   <source>{0} makes the {1}'s fillet reach its tip: no flank is left; use {2}</source>
   <translation>{0} lässt die Fußrundung am {1} den Kopf erreichen: keine Flanke bleibt; {2} nehmen</translation>
  </message>
  <message>
   <source>{0} makes the {1}'s fillets overlap: its root is rounded fully, with a radius of {2} mm instead of {3} mm; use {4} to keep a root land</source>
   <translation>{0} lässt die Fußrundungen am {1} überlappen: der Fuß ist voll gerundet, mit Radius {2} mm statt {3} mm; {4} nehmen, damit ein Fußgrund bleibt</translation>
  </message>
  <message>
   <source>{0} makes the {1}'s flanks meet below its tip cone: the teeth are pointed; use {2}</source>
   <translation>{0} lässt die Flanken am {1} sich unter dem Kopfkegel treffen: die Zähne sind spitz; {2} nehmen</translation>
  </message>
  <message>
   <source>{0} makes the {1}'s teeth touch each other at the foot: there is no tooth space; use {2}</source>
   <translation>{0} lässt die Zähne am {1} einander am Fuß berühren: es gibt keine Zahnlücke; {2} nehmen</translation>
  </message>
  <message>
   <source>{0} makes the {1}'s tip only {2} mm wide at the heel, less than {3} modules; a smaller addendum factor or profile shift makes it wider</source>
   <translation>{0} macht den Kopf am {1} an der Ferse nur {2} mm breit, weniger als {3} Module; kleinerer Kopfhöhenfaktor oder Profilverschiebung macht ihn breiter</translation>
  </message>
  <message>
   <source>{0} measured points are too few; a best fit takes 3 or more</source>
   <translation>{0} Messpunkte sind zu wenige; eine Einpassung braucht 3 oder mehr</translation>
  </message>
  <message>
   <source>{0} mm is more than half the outer cone distance of {1} mm; use at most {2} mm</source>
   <translation>{0} mm sind mehr als die halbe äußere Teilkegellänge von {1} mm; höchstens {2} mm nehmen</translation>
  </message>
  <message>
   <source>{0} mm is too narrow to make a tooth at an outer cone distance of {1} mm; use at least {2} mm</source>
   <translation>{0} mm sind zu schmal für einen Zahn bei einer äußeren Teilkegellänge von {1} mm; mindestens {2} mm nehmen</translation>
  </message>
  <message>
   <source>{0} of the points lie beside the {1}'s teeth: they are {2} to {3} mm from the apex and at {4}° to {5}° from the axis, its flanks at {6} to {7} mm and {8}° to {9}°; {10}</source>
   <translation>{0} der Punkte liegen neben den Zähnen vom {1}: sie sind {2} bis {3} mm von der Spitze und {4}° bis {5}° von der Achse, die Flanken {6} bis {7} mm und {8}° bis {9}°; {10}</translation>
  </message>
  <message>
   <source>{0} puts the {1}'s root cone at {2}°, and it must be above 0°; use {3}</source>
   <translation>{0} legt den Fußkegel am {1} auf {2}°, er muss über 0° liegen; {3} nehmen</translation>
  </message>
  <message>
   <source>{0} puts the {1}'s tip at {2}° to {3}° along the face and leaves no involute flank above its {4} cone of {5}°; use {6}</source>
   <translation>{0} legt den Kopf am {1} auf {2}° bis {3}° entlang der Breite und lässt keine Evolventenflanke über dem Kegel ({4}) von {5}°; {6} nehmen</translation>
  </message>
  <message>
   <source>{0} solids instead of {1} were found</source>
   <translation>{0} Körper statt {1} gefunden</translation>
  </message>
  <message>
   <source>{0} teeth</source>
   <translation>{0} Zähne</translation>
  </message>
  <message>
   <source>{0} to {1}</source>
   <translation>{0} bis {1}</translation>
  </message>
  <message>
   <source>{0} tooth of the {1}</source>
   <translation>Zahn, {0}, vom {1}</translation>
  </message>
  <message>
   <source>{0} tooth space</source>
   <translation>Zahnlücke, {0}</translation>
  </message>
  <message>
   <source>{0} tooth's lower side</source>
   <translation>Unterseite des Zahns, {0}</translation>
  </message>
  <message>
   <source>{0} {1} flank, cut off at its limits,</source>
   <translation>{0}, Flanke {1}, an ihren Grenzen abgeschnitten,</translation>
  </message>
  <message>
   <source>{0} {1} of at {2} {3}{4}</source>
   <translation>{1} {2} {3}{4}</translation>
  </message>
  <message>
   <source>{0} {1}solid{2}, {3} faces, {4} mm³ (relative difference {5})</source>
   <translation>{0} {1}Körper, {3} Flächen, {4} mm³ (relativer Unterschied {5})</translation>
  </message>
  <message>
   <source>{0} µm on the {1}'s {2} flank {3}; use {4}</source>
   <translation>{0} µm am {1}, Flanke {2}, {3}; {4} nehmen</translation>
  </message>
  <message>
   <source>{0} µm remained with {1} nodes where a step of the construction needs {2} µm; raise methods.tolerance_um</source>
   <translation>{0} µm blieben mit {1} Knoten, wo ein Schritt des Aufbaus {2} µm braucht; methods.tolerance_um erhöhen</translation>
  </message>
  <message>
   <source>{0}: the flanks touch on {1}: edge contact; less misalignment or more crowning avoids it</source>
   <translation>{0}: die Flanken berühren sich an {1}: Kantentragen; kleinere Einbaufehler oder mehr Balligkeit vermeidet es</translation>
  </message>
  <message>
   <source>{0}: {1} failed: {2}</source>
   <translation>{0}: {1} misslang: {2}</translation>
  </message>
  <message>
   <source>{0}° at the toe makes the mean spiral angle more than {1}°; use {2}</source>
   <translation>{0}° an der Zehe machen den mittleren Spiralwinkel größer als {1}°; {2} nehmen</translation>
  </message>
  <message>
   <source>{0}° gives the {1} a pitch cone of {2}°, and it must stay below 90°; use at most {3}°, or numbers of teeth nearer to each other</source>
   <translation>{0}° gibt dem Teilkegel am {1} {2}°, er muss unter 90° bleiben; höchstens {3}° nehmen, oder Zähnezahlen näher beieinander</translation>
  </message>
  <message>
   <source>{0}° makes the {1}'s face cone, {2}°, open backwards (above 90°) as that of an internal gear; a smaller shaft angle avoids it</source>
   <translation>{0}° öffnet den Kopfkegel am {1}, {2}°, nach hinten (über 90°) wie bei einem Innenrad; ein kleinerer Achsenwinkel vermeidet es</translation>
  </message>
  <message>
   <source>“{0}” stands in line {1} too; keep one of them</source>
   <translation>„{0}“ steht auch in Zeile {1}; behalten Sie eine davon</translation>
  </message>
 </context>
</TS>
