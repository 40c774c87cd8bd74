<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
 <context>
  <name>GearStudio</name>
  <message>
   <source> (+ {count} beside)</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source> and </source>
   <translation type="unfinished" />
  </message>
  <message>
   <source> and {count} more</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source> or </source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;About GearStudio</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;Backups…</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;Cancel</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;Clear the list</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;Copy</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;Differences only</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;Discard recovered</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;Display panel</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;Edit</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;Equations</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;Export…</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;File</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;Film…</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;Find a parameter</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;Full screen</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;Generating line on</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;Go back to this one</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;Guide</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;Help</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;Keys…</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;Layers</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;Model</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;New</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;Open design…</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;Open…</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;Panels</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;Preferences…</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;Quit</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;Rebuild</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;Redo</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;Report…</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;Reset layout</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;Reset settings…</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;Samples</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;Save</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;Save PDF…</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;Stop</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;Theme</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;Undo</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;Undock</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;Update preview</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;View</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>&amp;What is this?</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>1 problem</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>1 warning</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>14/35 teeth at 110°: a nearly flat wheel, and the same spiral angle everywhere on the face</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>15/45 teeth, 28° spiral everywhere, sphere ends as in the paper</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>16/32 teeth without spiral: teeth on straight lines to the apex, long and short addendum</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>17/40 teeth at 90° with a cutter arc of 80 mm and 35° spiral; the pinion's root lies inside its base cone</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>18/27 teeth at 45°: slender cones, long cone distance</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>19/43 teeth of module 20 mm, outer cone distance near half a metre</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>20/60 teeth of module 0.5 mm</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>25/50 teeth curved by the cutter, but with no spiral angle at the mean point; shaft angle 75°</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>3D</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>3D views drawn by</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>3MF unit</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>7 × 7 points inside the flank: root to tip, then on towards the heel</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>: not measured</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>; equation {printed} of the paper</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>A NURBS surface through discrete points on U and V lines</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>A circle on the sphere, tangent to root and flank (or to the meridian below the base cone); it scales with ρ.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>A click shows this method and variant; Ctrl+C copies the rows chosen</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>A few letters are enough; Up and Down choose, Enter carries out</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>A mark shows where the paper prints something else</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>A misprint under the root: the spherical right triangle gives cos²δ.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>A new language is complete after the next start.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>A number above 0, at most {most:g} kg/m³</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>A part of GearStudio could not be loaded: {text}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>A ratio that changes with n cannot be the count of points.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>A rear-axle ratio with few pinion teeth: strong profile shift, constant clearance, a little backlash</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>A round length; in perspective, of what is in the middle</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>A turned copy is the same flank of another tooth.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>A value with another unit can always be typed: 3in, 76.2mm. Deviations stay in µm and nm.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>AP203</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>AP214</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>AP242</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>AP242 is today's; AP214 and AP203 are for older programs</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>About GearStudio</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>About an axis through the centre of mass, square to the gear's axis</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>About the gear's axis</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Above this the CAD process is replaced when it is at rest; 0 for no limit</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Acute shafts</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Addendum angle</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Addendum at the heel over outer module, before profile shift.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Addendum factor</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Addendum, heel</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>After a crash, edits since the last copy are lost</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Against the effort</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>All can be told apart by colour-blind eyes</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>All files</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>All methods and variants in a table</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>All parameters are good</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>All points</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>All points of the generating line share the azimuth a of the line of contact: the plane is a rigid body.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>All teeth</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>All three</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Along the face</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Along the face, at half the depth of the flank</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Along the profile</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Along the profile, at the middle of the face</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Aluminium</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Analysis</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Angle at most</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Angle between pitch and base element</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Angle between the two axes; both pitch cones must stay below 90°.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Apex at the origin, axis along +z, teeth at z &gt; 0.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Archimedean miter pair</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Archimedean spiral</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Archimedean: the paper's spiral on the base cone. Circular arc: the cutter's path. Logarithmic: the same spiral angle everywhere.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Arcs of the tip and root circles between the flanks.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Area</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Arrows along the normals of the CAD flanks</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>As an azimuth on the pitch cone, with profile shift x and transverse backlash j_t.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>As it is</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>As made</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>As the paper has it, or refined until it meets the tolerance</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>As the system</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>As the theme</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>As {format}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Assembled from its faces</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Assign</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Auto</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Automatic</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Automatic range</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Automotive 9/41</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Axes</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Axial</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Axial face width</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Axial section of the blank; double-click to enlarge</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Axis of the section</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Azimuth</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Azimuth, from where it started, of a point of the plane that rolls on the base cone without slip.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>BREP as</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Back</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Back by a twelfth of a tooth</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Back cone: as blanks are turned. Sphere: as in the paper.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Back cones</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Background of the views</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Backlash</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Backups</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Base angle</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Base cone</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Base cone angle</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Base cone spiral</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Base radius</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Base radius, heel</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Base-cone spiral</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Best fit</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Between normals</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Bias</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Binary is five times smaller, text can be read</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Binary is smaller and quicker, text can be read</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Black</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Blank of the {member}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Blue – orange</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Borders of the flanks</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Bore diameter</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Both are the same.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Both flanks as the method made them, in one colour</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Both members</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Brass</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Bronze</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Browse…</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Build</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Build &amp;gear</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Build &amp;pair</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Build both gears and show them in mesh</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Build each method with growing effort; the design may be edited meanwhile</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Build every variant again</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Build the solid of the design as it is now</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Build the solids anew after every edit</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Build the whole gear as a solid and show it</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Building alone, both flanks</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Building and checking</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Building the {member} as a solid</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Building {method}, {variant}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Built in</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>CAD flanks</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>CAD flanks coloured by deviation or curvature</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>CAD kernel busy</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>CAD kernel ready</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>CAD kernel restarting…</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>CAD kernel starting…</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>CAD kernel stopped</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>CAD surface</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>CSV, .dat, or columns x y z and, if there are, nx ny nz, in mm; or a STEP file of the gear</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Can be selected and copied</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Cancel</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Cancelled; Build builds it</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Cancelled; Rebuild builds it</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Cast iron</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Centre z</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Change {field} to {value}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Chart</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Charts</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Choose a command to change its keys</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Choose a design</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Choose a design to compare with the one that is open.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Choose a file format</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Choose a folder</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Choose another colour for this layer</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Choose what goes in, then Update preview.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Chordal addendum, mean</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Chordal addendum, outer</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Circular arc (milled)</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Circular plane of radius R that rolls on the base cone</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Clear</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Clear where nothing is; for slides and papers</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Clearance factor</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Clearance over depth</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Click into a table first</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Click the second point.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Click to see it in the view.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Click two points of the solid.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Click two points: their distance and what lies between</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Close</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Close the display panel</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Close the report</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Close; every choice is already in force</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Close; what is being painted is given up</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Closed</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Co&amp;mpare with design…</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Coarse</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Coarse mill drive</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Coast</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Colour and opacity of {layer}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Colour of the layer</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Colour scale</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Coloured flanks</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Colours</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Colours of the members and of their flanks</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Colours of the window</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Colours, surface quality, cameras and ground of the views</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Colour…</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Combs</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Command</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Command &amp;palette…</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Command or parameter</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Command palette</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Commands</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Commands and their keys</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Commands found</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Common apex</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Common apex: all cones share the apex, as in the paper. Constant clearance: the tip runs parallel to the mate's root.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Compare designs</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Compare with design</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Compare with the design of a file</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Comparison</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Comparison of all methods and variants</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Compound</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Compute the report of the design as it is now</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Computed</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Concave</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Concave flank</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Cones</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Constant clearance</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Construction</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Contact</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Contact pattern</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Contact pattern and transmission error, with misalignments</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Contact pattern, ease-off and transmission error, drive and coast</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Contact ratio</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Contact ratios</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Contour lines</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Contours</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Contours every {step} µm; 0 at the mean point</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Control points of the heavier flank</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Control points of the surface, u × v</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Convergence</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Convex</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Convex flank</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Copied the chart: picture and numbers</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Copied the data sheet as {format}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Copied; paste it into a spreadsheet</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Copy</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Copy &amp;derived values</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Copy &amp;diagnostics</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Copy &amp;table</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Copy all of the report</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Copy co&amp;mparison</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Copy of unsaved work every</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Copy report</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Copy table</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Copy the comparison table as text</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Copy the derived values as text</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Copy the entries that are shown</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Copy the message with its details</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Copy the picture and the numbers</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Copy the picture to the clipboard</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Copy the sheet</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Copy the table for a spreadsheet</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Copy the table with the focus, for a spreadsheet</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Copy the values as a table</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Copy versions, design and log for a report</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Copy what is chosen in a table or text</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Count</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Crown to apex</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Curvature</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Curvature combs</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Curvature itself, or its difference to the exact flank</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Curvature of the modelled flanks, as the paper's Fig. 11, or its difference to theory</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Curves along the tooth that guide the surface</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Custom</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Cut</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Cut from the blank (slow)</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Cut square to the {axis} axis</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Cutter radius</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Dark</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Dark – bright</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Data sheet</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Data sheet or published values</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Decide &amp;later</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Decimals</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Dedendum angle</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Dedendum, heel</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Default spiral bevel pair</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Default: {value}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Degree</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Degree of the surface through the point cloud.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Degree of the surface, u × v</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Density</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Density of points</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Density of the material in kg/m³</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Depth</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Depth factor</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Depth system</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Depths</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Derived values</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Derived values of both members</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Design</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Design in use</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Design, data sheets, comparison, maps, contact and equations as a PDF</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Designs that were saved on this computer</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Designs with unsaved work</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Designs, backups and unsaved work stay. The old settings are kept as a .bak file.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Details</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Details of the message</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Deutsch</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Deviation</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Deviation against positions, sections or points, poles, and seconds</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Deviation along a series of points, as the paper's Fig. 12</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Deviation along points, histogram</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Deviation as a bar at each point, both flanks drawn flat</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Deviation maps</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Deviation of a point</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Deviation, absolute</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Deviation, {kind}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Deviations of all methods and variants, as a table and along the flank</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Diameter of a solid shank behind the back face, 0 for none; it replaces the bore.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Diameter of the bore, 0 for none; leave empty to derive it from the pair.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Diameters</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Difference</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Differences</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Different: {fields}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Differs from what is open in</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Digits after the point of lengths in mm and angles; two more in inches</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Dimensions of both members with the standard's names</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Direction</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Direction of the curvature combs; the layer list switches them on</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Direction of the lamps</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Directions x, y and z of the gear</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Dismiss</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Display</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Display and work as for a new user; keys have a button of their own</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Distance</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Distance between the axes of a hypoid pair; 0 is a bevel pair. Positive makes the pinion's spiral angle the larger one. With an offset the outer module and the face width are the wheel's.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Do again what was taken back</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Done again: {step}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Drag the card to where it hides nothing</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Draw the edges of the faces</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Drawing by software failed too; install or update Mesa (libgl1-mesa-dri) or the driver.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Drive</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Duplex</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Each save leaves a copy. Going back changes no file until you save, and can be undone.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Ease-off</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Edges</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Effort</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Empty the panel; the log file stays</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Enclosed</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>End chamfer</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>End the CAD process and start a new one</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>End the measurement</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>English</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Enter or a click carries out</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Equations</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Errors</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Errors [µm]</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Errors and statistics of the measured points</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Esc</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Evenly divided; by arc length or denser at the ends on request.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Every field of the design with symbol, value and unit</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Every formula, what the paper prints, and this design's numbers</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Every value of the pair; a row explains itself</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Everything</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Everything else works: parameters, comparison, charts, data sheets and exports.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Expand the analysis</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Explain the parameter with the cursor, or what is clicked</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Export</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Exporting {label}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Exports</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Face and root cone angles</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Face angle</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Face apex beyond crossing point</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Face width</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Face width along the pitch cone; leave empty to take the factor.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Face width factor</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Face width over outer cone distance; a face width in mm wins over it.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Faces</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Faces joined into one shell, or tooth spaces cut from the blank by Booleans</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Fields that differ from their defaults; the context menu resets the group</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Fields with a problem</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Files</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Fillet factor</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Fillet radius</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Fillet radius on the heel sphere over mean normal module.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Fillet radius, heel</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Film</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Find a command or a key</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Find a parameter</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Find an equation</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Find any command or parameter by a few letters</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Find in the page</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Fine</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Fine instrument pair</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Fit all</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Flank</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Flank colours</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Flanks coloured by deviation</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Flanks of one tooth</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Flat: the flanks are conjugate</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Fold all groups</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Fold or unfold this group</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Folder</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Folder for the exported files</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Folder not found</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>For the Archimedean spiral with β₀ at the toe; for other curves the same difference θ(R) − θ(R − B).</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Forget layout, lists and preferences; designs stay</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Forget the edits that were not saved</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Forget the layout, the list of recent files and all preferences?</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Frames</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Frames in a second</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>From [{unit}]</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>From the apex</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>From the apex to the back face.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>From the back face toward the apex; the toe limits it.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>From the heel</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>From the toe to the heel.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>From the wheel's pitch cone to its face cone; leave empty to take the taper's.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>From the wheel's root cone to its pitch cone; leave empty to take the taper's.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Front</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Front crown to apex</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>G  wheel axial</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>G&amp;lossary</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>GLB unit</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>GLB up</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Gap</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Gap between the flanks beyond that at the mean point, with contours</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Gaussian</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Gaussian curvature</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Gaussian curvature of the surfaces and of theory</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Gear designs (*.gear.toml);;All files (*)</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Gear ratio</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>GearStudio ended unexpectedly. Of these designs it kept edits that were not saved.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Generating line</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Generation</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Geometry data sheet</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Geometry of both members; every value explains itself</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Give every command its usual keys</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Give every parameter its default back; can be undone</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Give the analysis the room of the 3D views</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Give the command its usual keys</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Give the command these keys</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Give the field with the cursor its default back</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Give the film up; no file is left</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Glossary</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Go back to one of the last saves</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Go back to the save of {date}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Go on with the edits that were not saved</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Graphics and memory take effect at the next start.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Grey</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Greys</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Ground</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Group</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Guide</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Guide curve along the tip</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Guide curves</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Guide curves follow the flank on tip and root.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Half the tooth's thickness</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Half the tooth, azimuth on the pitch cone</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Hand of spiral</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Hand of spiral of the pinion; the wheel has the other.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Hand of the pinion</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Headings</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Heel and toe profiles, sections and positions used</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Histogram</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>How a whole gear is put together</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>How far the plane has rolled. It starts at 0 where the root lies below the base cone.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>How far triangles may lie from the surfaces; left empty, 1e-4 of the outer cone distance</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>How many colours</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>How many points are taken of a CAD model's flanks</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>How much of the layer one sees; as made, some layers are glass</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>How often which deviation occurs</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>How the value came about</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>How they are written</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>How to use the studio</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Hub diameter</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Hub length</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>IGES bodies</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>IGES unit</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>ISO 23509:2016, sample F.2, spiral bevel pair 14/39</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>In the chosen material</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>In the design file: {key}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Inches</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Inertia x</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Inertia z</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Inner addendum</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Inner clearance</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Inner cone distance</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Inner dedendum</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Inner pitch diameter</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Inner root diameter</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Inner tip diameter</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Inner whole depth</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Iso23509</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Isometric</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>It could not be put aside.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>It is kept as {file}.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>It needs “{choice}” as {field}.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>KHK gear technical reference, Gleason spiral bevel pair 20/40</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Keep a record of the check beside each file</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Keep everything; File ▸ Recover unsaved work, or the next start, asks again</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Keys</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Keys of all commands</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Lamps</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Language</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Largest</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Largest angle between neighbouring chords; left empty, the distance alone decides</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Largest between neighbouring faces</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Largest deviation against poles and seconds of each method</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Largest deviation from the exact flank, over both flanks</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Largest deviation over both flanks</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Largest principal</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Layers</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Leave it empty to use the derived value shown in grey.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Leave out what both designs have in common</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Left</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Left hand</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Length</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Length of the combs; teeth longer than three typical ones are cut off</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Length of the film</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Length of the shank behind the back face, 0 for none.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Lengths in</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Lengthwise</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Lengthwise crown</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Lengthwise crowning</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Lengthwise curve</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Less theory</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Less theory, in %</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Let the range follow the values shown</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Letters of a command, or a key such as Ctrl+S</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Level</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Light</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Limit pressure angle factor</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Linear</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Lines of equal value at the marks of the colour scale</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>List and change the keys of all commands</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Log</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Logarithmic pair</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Logarithmic spiral</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Longest: {length}; up is metal added</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Look for edits that a window which ended unexpectedly had not saved</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Lower end of the scale</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Lowest … highest</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Map</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Maps and charts of</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Margins</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Mass</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Material</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Material that the mass is computed with</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Max</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Mean</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Mean addendum</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Mean addendum factor</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Mean clearance</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Mean cone distance</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Mean curvature</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Mean dedendum</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Mean normal module</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Mean of the absolute deviations</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Mean pitch diameter</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Mean root diameter</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Mean tip diameter</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Mean whole depth</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Mean, pitch cone</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Mean: at the mean point on the pitch cone. Toe: at the toe on the base cone, as the paper gives it.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Measure</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Measured in the tangent plane; it is the arc ψ at which the involute crosses the pitch cone.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Measured points</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Measured points against theory</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Measured points and models</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Measured points on the gear, coloured by their deviation</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Measurement</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Member</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Member whose mean spiral angle is given; both have the same without an offset.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Memory of the CAD kernel</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Memory, graphics and recovery</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Menu</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Metal at the corners root-toe and tip-heel more than at the other two.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Metal at the heel more than at the toe, over the whole face; nothing changes in the middle.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Metal at the tip more than at the root, over the whole depth of the flank; nothing changes in the middle.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Metal taken off at root and tip of the flank, rising as a parabola from the middle of its depth.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Metal taken off at the lower edge of the flank; it fades out as a cube, without a kink.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Metal taken off at the tip; it grows from where it starts as a cube, without a kink in slope or curvature.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Metal taken off at toe and heel, rising as a parabola from the middle of the face.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Method</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Method comparison</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Methods</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Micro-geometry</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Micro-geometry: pinion, concave</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Micro-geometry: pinion, convex</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Micro-geometry: wheel, concave</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Micro-geometry: wheel, convex</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Millimetres</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Modified contact ratio</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Motion</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Mounting distance</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>NURBS surface</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Name</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Names</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Names of the members and of every face</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>New &amp;window</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>New key</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Next</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Next place where the words stand</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>No 3D views</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>No contact</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>No limit</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>No misalignment, usual marking compound</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>No parameter has these words</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>No picture: {why}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>No points</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>No points yet: open a file of measured points in mm, or a STEP file; apex at the origin, axis along z.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Nominal grid…</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Normal chordal thickness, mean</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Normal circular thickness, mean</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Normal pressure angle, mean point</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Normal to the flank, positive where metal is added; exact to second order, beyond which the foot point is iterated.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Normal, mean point</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Normal: in the normal section at the mean point, as standards give it. Transverse: as the paper gives it.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Normals</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Not built yet</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Not used now.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Nothing is lost: save the design in another folder.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Now: {value}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Number</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Number of faces of the solid</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Number of stripes</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Number of teeth</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Number of teeth of the pinion.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Number of teeth of the wheel.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Obtuse shafts, logarithmic spiral</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Of mass, from the apex</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Of the disc between hub and rim, from the back face.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Of the edges between tip and ends of the teeth, turned over all teeth at toe and heel; its legs along the face cone and along the end, 0 for none.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Of the whole surface</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Offset</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>On by a twelfth of a tooth</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>One camera for all</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>One closed shell</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>One of: {choices}.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>One tooth</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>One tooth was measured: there is no pitch to compare</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>One unit of the file is a metre, as glTF asks; mm is for programs that do not scale</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Only one window can save it. Read-only, Save asks for another name; a copy starts as a new design.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Only the Archimedean spiral can take its angle at the toe.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Only the rolled arc is divided by sin δ_b: the second term is an angle about the axis already.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Opacity</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Open &amp;read-only</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Open &amp;recent</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Open &amp;recovered</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Open &amp;saved</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Open a &amp;copy</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Open a design file (.gear.toml)</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Open another window, with a CAD process of its own</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Open design</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Open measured points or a STEP file</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Open points or STEP…</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Open the file as it was saved; the recovered edits stay</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>OpenGL {needed} is needed, and {renderer} offers {version}.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Optimised</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Other</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Other design</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Out of date: the design has changed</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Outer addendum</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Outer clearance</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Outer cone distance</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Outer dedendum</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Outer diameter of the hub, on the side of the apex.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Outer module</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Outer module: the factors of the tooth, over the outer module at the heel. ISO 23509: factors of the mean normal module at the mean point, with a taper.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Outer pitch diameter</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Outer root diameter</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Outer tip diameter</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Outer transverse module</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Outer transverse module: heel pitch diameter over teeth.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Outer whole depth</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Overlap ratio</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>P  pinion axial</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>PDF files (*.pdf)</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Page</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Page {number} of {count}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Pages of the preferences</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Pair</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Pair in mesh</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Pair in mesh, on by one tooth</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Paper</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Parallel</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Parallel shows true proportions</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Parameter</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Parameters</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Parameters and derived values beside those of another design</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Parameters: {group}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Part</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Paste</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Pattern</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Peak to peak</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Perspective</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Pi&amp;cture…</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Picture</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Picture of</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Pinion</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Pinion along its axis, positive away from the crossing point</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Pinion axis beside the wheel's, positive as a positive hypoid offset</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Pinion blank</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Pinion teeth</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Pinion {pinion:.1f}° · wheel {wheel:.1f}°</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Pitch</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Pitch angle</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Pitch cone</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Pitch cone angle</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Pitch diameter, heel</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Pitch error</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Pitch to base element</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Pitch to base element, in the tangent plane</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Pitch, single</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Pitch, total</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Pixels of the picture for one on the screen</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Place along the face</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Place along the profile</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Place of the section</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Places along the generating line</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Play</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Point</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Point cloud</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Point cloud degree</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Point in spherical coordinates</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Point series</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Points</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Points and surfaces</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Points of the exact flank on U and V lines</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Points, U and V lines</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Poles</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Positions, sections, or points along each side of the grid</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Preferences</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Preparing 3D view…</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Preparing the analysis…</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Press the new keys here</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Pressure angle</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Pressure angle correction</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Pressure angle is</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Pressure angle of both flanks.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Pressure angle, normal</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Pressure angle, transv.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Preview of the report</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Principal 1 (largest)</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Principal 2 (smallest)</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Printed 0.963 rad; used 0.286 rad, which gives back β₀ at the toe (17/40 teeth, m = 4 mm, wheel).</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Printed 21.1°; used 59.863°, which equals arcsin(sin δ cos α) (17/40 teeth, m = 4 mm, transverse 20°, wheel).</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Profile at the toe</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Profile crown</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Profile crowning</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Profile shift</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Profile shift factor</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Profile shift factor of the pinion; the wheel takes the negative.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Profile sweep</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Progress of the measurement</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Progress of the study</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Projection</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Properties</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Properties of the solids</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Published</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Published values</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Published values and those computed</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Purple – green</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Put every panel back in its place</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Put it in place of what is open; Undo takes that back. No file is changed.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Put the cursor into a parameter first</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Quantity</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Radial</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Radius of the back plane of the base cone.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Radius of the cutter whose arc the tooth follows.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Radius of the tangent circular plane, which is the heel sphere's.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Range: {limits}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Re&amp;start CAD kernel</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Reading {file}…</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Rebuild when the design changes</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Reco&amp;ver unsaved work…</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Recover unsaved edits</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Recover unsaved work</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Recovered version</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Refined until the expected deviation is below the tolerance</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Reflections of straight lamps in the CAD flanks</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Remove &amp;missing ones</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Report</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Reset</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Reset &amp;field</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Reset a&amp;ll parameters</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Reset all keys</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Reset all parameters</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Reset group {group}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Reset settings</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Reset this group</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Reset to &amp;sample</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Reset to {preset}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Reset to {value}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Reset {field}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Restore defaults</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Right</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Right hand</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Rms</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Roll angle from root to tip</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Roll of the tangent plane</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Roll of the tangent plane: {degrees:.1f}°</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Roll the plane and let the line sweep out the flank</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Rolling construction at δ_k = 68°: azimuth 0.0413879 rad, as the used form; the printed form gives −0.0838 rad (17/40 teeth, transverse 20°, wheel).</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Rolling of the tangent plane</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Root angle</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Root apex beyond crossing point</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Root of the mean square</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Root of the mean square deviation</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Root relief</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Root relief ends at</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Root – tip</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Rotating line</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Run</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Run the study: each method is built with growing effort</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>STEP schema</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>STEP unit</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>STL as</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Save &amp;as…</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Save a turntable, the pair in mesh or the rolling plane as MP4 or GIF</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Save as .mp4 or .gif</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Save as .png or .jpg</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Save as PNG, SVG or CSV…</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Save chart</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Save data sheet</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Save design</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Save film</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Save nominal grid</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Save or copy a picture of the views or the window</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Save picture</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Save the changes to “{name}”?</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Save the design</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Save the design under another name</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Save the report</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Save the sheet</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Saved</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Saved the chart as {written}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Saved the data sheet as {path}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Saved the film as {path}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Saved the last good design; {count} field(s) with problems are not in {name}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Saved the nominal grid of the {member} as {path}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Saved the picture as {path}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Saved version</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Saved {path}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Saved, but no backup could be kept: {reason}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Save…</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Scale</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Scale bar</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Scale of the combs</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Scale of the deviations: Auto is logarithmic where the curves differ by orders</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Search the parameters by title, symbol or description</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Seconds</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Section</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Section of the {member}'s blank</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Sections</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Select all</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Sentences</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Set of layers</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Settings</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Shaft angle</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Shaft angle beyond its nominal value</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Shank diameter</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Shank length</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Share of the flank's depth, from 0 at its lower edge to 1 at the tip; no effect without root relief.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Share of the flank's depth, from 0 at its lower edge to 1 at the tip; no effect without tip relief.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Share of the limit pressure angle that the drive flank gains and the coast flank loses; no effect without an offset.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Share of the points</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Shift</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Shifted by</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Show</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Show everything as in a new window; layers keep their colours</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Show the pinion and build its flanks</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Show the wheel and build its flanks</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Show what else is known</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Show: {words}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Shown and typed in this unit; files stay in mm</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Side of the teeth</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Signed extremes: most metal missing, most metal added</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Signed normal deviation of the solid's flanks from theory</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Single and cumulative pitch errors</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Size</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Size of the film in pixels</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Smallest principal</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Smooth</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Software, without the graphics card</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Solid</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Solids know which faces meet; trimmed surfaces are for programs that know no solids</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Something unexpected went wrong. The window goes on, and the design is still there: save it under a new name to be safe. The report below helps to mend the fault; it is also in {path}.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Speed</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Speed; at 1× one tooth passes each second</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Spheres</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Spherical involute</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Spherical involute, 14/39, transverse pressure angle 20°</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Spiral angle</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Spiral angle at</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Spiral angle at the cone distance R' of a tooth trace that is an arc of the cutter's radius r₀.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Spiral angle correction</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Spiral angle of</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Spiral angle, heel</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Spiral angle, mean</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Spiral angle, toe</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Spiral angle; 0 gives straight teeth, or zerol teeth with the circular arc.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Spiral bevel gears from the exact spherical involute: three ways to model the tooth flanks, side by side, and how far each is from theory.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Standard</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Standard depth with a common apex; with constant clearance the face cone is turned parallel to the mate's root cone instead.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Standard: root lines through the pitch apex. Uniform: the same depth from toe to heel. Duplex: constant slot width. Tilted root: constant slot width, but not steeper than 1.3 times standard.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Standards give the pressure angle in the normal section at the mean point, the paper in the transverse one.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Start from the default design</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>State</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Steel</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Stop making the report</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Stop the work in progress</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Stop the work in progress (Esc)</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Stopped</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Straight bevel pair</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Stripes</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Surface quality</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Symbol</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Take away the other side</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Take away what lies beyond a plane and show the cut face</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Take back the last edit</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Take colour and opacity back</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Take over</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Take the marker away (Esc)</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Tangent plane</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Taper</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Teeth</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Teeth as long as the CAD flank is curved</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Text</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The 3D view could not be loaded.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The 3D views are switched off in the preferences (graphics).</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The CAD kernel could not be started. Model ▸ Restart CAD kernel tries again.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The CAD kernel stopped unexpectedly and is being restarted; nothing of the design is lost.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The CAD process had grown to {size} MB and was started anew; nothing is lost.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The analysis could not be loaded.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The axis that viewers take as up is y, as glTF asks; z keeps the gear's own axes</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The azimuth β is where the point is, the roll angle Θ is how far the plane rolled: not the same angle.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The basis functions then do not add up to one.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The best fit may shift the part along its axis</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The best fit may turn the part about its axis</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The chart was not saved: {error}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The cone on which the generating plane rolls.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The cone on which the plane rolls</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The cone that rolls on the mate's</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The construction as printed: few positions, two profiles, 7 × 7 points</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The construction whose surfaces are written</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The cutter's radius is missing below the line.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The data sheet was not saved: {error}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The design to compare with</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The designs cannot be compared: {reason}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The deviations that the paper states of its own gear, for comparison</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The division by the cosine does not agree with equation (7).</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The equation</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The exact flank, translucent</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The export failed: {text}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The face width is given as a length: empty that field to use the factor.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The flank</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The flanks of the three methods in perspective</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The folder of “{name}” is no longer there:
{folder}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The formulas used, the paper's departures, and this design's numbers</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The generating line, moved rigidly as the tangent plane rolls on the base cone</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The generating line, rolled by Θ, lies on the flank to 4·10⁻¹⁴ mm.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The kernel's full check of the solid</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The line in the plane, and the flank it has swept</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The measurement was cancelled.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The measuring grid with a bar at each point, both flanks</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The member, or both where they mesh</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The methods are being built…</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The nominal grid was not saved: {reason}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The opposite flank</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The optimised variants refine until they expect to be below it.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The other flank of the tooth is the mirror image about the tooth's middle.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The other teeth and the body, in light grey</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The pair</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The pair in mesh</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The paper prints</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The paper turns the flank.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The paper: mean deviation of its three methods; the data of its gear are not printed</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The picture is on the clipboard</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The pinion's concave flank leads</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The pinion's convex flank leads</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The pitch cones of two gears with crossing axes roll on each other; z' are the mate's teeth. For a right angle it is the paper's arctan z / z'.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The point of the flank under the pointer</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The printed bound does not return the spiral angle it is made from.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The printed form is a length, not a number; the used one meets tan β = ρ ψ′(ρ) to 10⁻⁸.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The printed form is a ratio of lengths, not a count.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The process that builds flanks and solids</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The publication does not print the data from which it could be computed</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The report could not be made: {reason}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The rolling plane's point</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The settings are reset; some take effect when GearStudio starts again.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The settings file was damaged, so the window starts with the usual settings. {where}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The sum divides by zero</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The sum has no finite value</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The sum has no value: look at the arguments of its functions</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The sum is longer than {count} characters</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The system refused to start another window.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The theoretical surface, explicit in azimuth: the deviation of any point from it needs no search.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The three methods side by side, seen from the same place</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The tooth is self-similar: every section is the heel's, scaled by ρ and turned by θ(ρ).</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The tooth profile, swept from heel to toe along the tooth trace</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The tooth that is drawn</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The turn θ(ρ) is missing.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The views</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The weights are missing above the line.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The wheel's mean addendum over working depth; leave empty for 0.21 + 0.29/u₉₀².</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The whole window</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The window alone on the screen, and back</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The words of the field, as they are used here</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The {flank} flank</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Theme</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Theoretical flank</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Theory</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Theory {equation}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Theory, section {section}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>There are no backups yet; each save of a design makes one.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>There is no unsaved work to recover.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>There is no {field} to begin or end.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>These are the values of an earlier design; of this one there are none: {error}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>These sizes make no blank; the field says why.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>They are lost if you do not save them.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Thickness</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Thickness factor</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Thickness of the marking compound: where the gap is less, it is wiped off</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Thickness that the pinion's teeth gain over the wheel's, over mean normal module.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>This design</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>This design was never saved.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>This display offers no OpenGL.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Tick a format to see how it can be written.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Tilted root</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Time</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Time to build both flanks</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Tip and root</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Tip clearance at the heel over outer module.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Tip clearance over working depth.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Tip cone</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Tip land, heel</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Tip land, toe</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Tip relief</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Tip relief starts at</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Tip, fillets, root and ends of the tooth, in light grey</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Titles, axes and scale bar</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>To [{unit}]</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>To draw without a graphics card, start GearStudio with: --graphics software</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Toe – heel</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Toe, base cone</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Tolerance</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Tooth</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Tooth contact</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Tooth ends</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Tooth profile</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Tooth trace of a cutter</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Tooth {number}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Topography</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Total contact ratio</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Transmission error</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Transparent background</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Transverse</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Transverse backlash at the heel pitch circle, half from each member.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Transverse backlash, outer</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Transverse chordal thickness, outer</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Transverse circular thickness, mean</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Transverse circular thickness, outer</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Transverse contact ratio</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Transverse contact ratio on the heel sphere, and overlap ratio.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Transverse pressure angle</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Triangles within</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Turn</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Turn of the pinion</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Turn of the spiral from toe to heel</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Turn the pair in mesh</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Turn the views together, or each by itself</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Turned by</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Turns the lamps</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Turntable</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Two equal gears at 90° with the Archimedean spiral, the spiral angle given at the toe as in the paper</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Type a command or a parameter</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Undercut margin: rolled arc left below the mate's tip</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Undone: {step}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Unexpected error</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Unfold all groups</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Uniform</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Unit</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Unit of deviations on the colour scale and in the views</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Unit of length in the file; the gear keeps its size</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Units, colours and language</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Units, theme, language, memory and keys</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Unsaved changes</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Unsaved edits cannot be kept for recovery: {reason}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Untitled</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Up to date</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Up to ± [{unit}]</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Upper end of the scale</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Usual</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Valid</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Values at the picked point</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Values with a unit can be added, but not multiplied with each other</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Variant</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Views</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Virtual normal diameter, mean</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Volume</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Volume, mass and moments of the solids that are built</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Warnings and errors</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Web thickness</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Weights above and below the line.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>What colours the CAD flanks</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>What draws the 3D views</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>What else is known</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>What follows from the parameters</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>What is in the picture</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>What is this?</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>What is written over the views</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>What is wrong with the parameters</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>What moves in the film</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>What of it</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>What others printed, computed again</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>What the construction took</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>What the lamps are fixed to</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>What the program noted, the newest last</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>What this design is called.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>What this is, and the versions of its parts</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>What was made and what was found, for “gearstudio verify”</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>What was written beside the project, and what was found on reading it back</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Wheel</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Wheel along its axis, positive away from the crossing point</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Wheel axis along +z; the flanks are exactly conjugate.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Wheel blank</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Wheel teeth</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Where each method deviates from the exact flank</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Where the involutes start on the base cone</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Where the involutes start; the generating line is this curve unrolled into the tangent plane.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Where the marking compound is wiped off</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Where the plane of the section stands</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Which entries are shown</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>White</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Whole gear</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>With the camera</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>With the gear</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>With the printed form equation (7) gives R = 222.2 mm instead of 86.9 mm (17/40 teeth, m = 4 mm, transverse 20°, wheel).</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>With {value} no derived value would change.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>With {value}:</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Within {value}: {efforts}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Without it the guide leaves the flank of a spiral tooth.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Words of the title or the text, or the paper's number</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Words of the window</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Words of title, symbol, description or group</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Work</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Working depth at the mean point over mean normal module.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Working flanks</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Write flanks, teeth, gears or the pair for other programs</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Write the nominal points with normals, for a coordinate measuring machine</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Writes {names}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Wrote {names} to {folder}; read back and checked</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Wrote {name} to {folder}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Zebra stripes</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Zerol pair</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>addendum</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>and {count} more</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>apex to crown</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>at least {low}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>at most {high}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>axial face width</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>azimuth at the pitch cone</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>base</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>base angle</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>basic render</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>binary</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>body</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>box {box} mm · read by {kernel}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>building…</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>coast</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>computing the curvature…</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>concave</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>concave fillet</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>concave flank</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>concave meridian</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>convex</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>convex fillet</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>convex flank</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>convex meridian</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>cut</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>dedendum</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>dedendum angle</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>derived</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>deviation {value}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>drive</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>end</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>even</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>face angle</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>fillet</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>first method, mean</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>flanks</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>flat</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>frame {n} of {all}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>gap {value} µm</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>gear</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>grid</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>guides</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>heel</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>inch</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>inner cone distance</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>inner outside diameter</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>inner pitch diameter</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>inner spiral angle</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>kernel</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>largest</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>least</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>left out</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>max {largest} · mean {mean}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>mean cone distance</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>mean normal module</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>mean pitch diameter</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>mean {value} µm</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>mm</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>modifications</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>more than {low}, up to {high}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>most</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>names, colours, product structure</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>never saved</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>no</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>no curvature to show</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>non-uniform</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>none</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>not computable</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>not valid: {count} problems</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>not valid: {problem}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>nothing</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>number</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>optimised</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>outer cone distance</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>outer module</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>outer pitch diameter</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>outer spiral angle</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>outside diameter</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>pair</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>paper, equation {number}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>parameters</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>pinion</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>pipe along the tooth trace</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>pitch angle</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>point_cloud</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>points</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>points along each side</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>poles</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>positions</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>process {number}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>process {number} on {host}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>profile_sweep</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>psi, trace</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>published</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>record: {name}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>roll angle at the pitch cone</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>root</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>root angle</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>rotating_line</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>second method, mean</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>section 3</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>section 4</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>section 5</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>sections</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>skin</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>smallest</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>solids</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>spacing</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>surfaces</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>surfaces, for older programs</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>sweep</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>text</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the CAD kernel's own</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the file is gone</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the mate has no flank here</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the paper's own gear: {low} … {high} µm, means {means} µm</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>theory, section {number}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>third method, mean</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>tip</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>toe</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>tolerance {value}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>tooth</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>triangles alone</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>triangles in colour, for viewers</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>triangles within {um} µm of theory ({limit} µm allowed)</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>triangles, for printing</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>updating…</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>updating… (max was {largest})</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>valid</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>waiting for the CAD kernel</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>waiting for the CAD kernel…</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>waiting for the CAD process</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>waiting…</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>wheel</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>writing…</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>yes</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{count} changed</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{count} constructions failed. </source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{count} entries, {bad} warnings or errors</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{count} of {all}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{count} of {all} values differ; the difference is other minus this.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{count} pages, {size:.1f} MB</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{count} problems</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{count} steps</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{count} warnings</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{count}: the last good model stays</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{faces} faces · flanks within {largest} · built in {took}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{file}, against the {member}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{file}, against the {member}: points of {flanks} flank faces of {faces}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{keys} belongs to “{command}”, which would lose it.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{low} to {high}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{member} {face}: within {largest} µm of theory ({limit} µm allowed)</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{member}, cut face</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{member}, {face}, tooth {number}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{member}, {flank} flank</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{member}, {flank} flank: all points of the deviation map</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{member}: no blank yet</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{name} (missing)</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{name} (read-only)</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{name} was not opened: it has {count} problems, the first at {problem}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{name} was not opened: {problem}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{name} was not saved: it is open in another GearStudio window ({holder})</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{name} was not saved: {problem}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{name}, cumulative</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{name}, single</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{passed} of {all} published values agree to the last printed digit</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{summary} ({section} of the paper)</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{text} ({done} of {all})</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{title} [{unit}]
Drag an end of the bar to change the range, double-click to type it. Grey: no value there</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{title} curvature [{unit}]</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{title} curvature less theory [{unit}]</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{title}: a number from {low} to {high} {unit}, or nothing</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{title}[*] – GearStudio</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{words}; {failed} do not.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{w} × {h} pixels</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Σ  shaft angle</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>“{command}”: usual keys {keys}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>“{name}” is not known here</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>“{name}” is open in another GearStudio window ({holder}).</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>“{text}” is neither a number nor a sum</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>“{unit}” does not suit this field</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>✓ pass</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>✗ fail</source>
   <translation type="unfinished" />
  </message>
 </context>
 <context>
  <name>Sentences</name>
  <message>
   <source>"toe" is defined for the Archimedean curve only, and the curve is "{0}"; use "mean", or the curve "archimedean"</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>; use an offset of 0 mm</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>; use {0} mm or nearer to 0</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>a back face {0} mm from the apex cuts into the roots at the heel; use at least {1} mm</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>a bore of {0} mm leaves no wall under the roots; use at most {1} mm</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>a chamfer at the end of the teeth cuts a face more than once</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>a chamfer at the end of the teeth does not cut off their tips alone</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>a chamfer of {0} mm is too small to be modelled; use 0 for none, or at least {1} mm</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>a chamfer of {0} mm leaves no tip between toe and heel or reaches the roots; use at most {1} mm</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>a chart is saved as {0}, not as {1}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>a constant slot width would taper the depth by {0}°, beyond {1}°; use {2}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>a coordinate of the measured points is not a number</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>a cutter of radius {0} mm does not cross the wheel's whole face width; {1}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>a cutter of radius {0} mm does not cross the whole face width</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>a face is missing or not valid</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>a face width of {0} mm does not fit a wheel of {1} mm; use less than {2} mm</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>a fillet of {0} mm on the {1} reaches into the {2} flank that meets the wheel's tip</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>a grid of {0} x {1} points has no area; use 2 or more each way</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>a grid of {0} x {1} points is too coarse for a contact analysis; use 3 or more</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>a hub of {0} mm must lie between the bore and the rim; use more than {1} and less than {2} mm</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>a hub {0} mm long reaches beyond the toe; use at most {1} mm</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>a larger pressure angle or more teeth</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>a marking compound {0} µm thick leaves no mark; use more than 0</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>a misalignment and the thickness of the marking compound must be finite numbers</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>a narrower face width</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>a part of the path is a file, not a folder</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>a picture needs a name that ends in {0}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>a shaft angle of {0}° makes the wheel's pitch cone {1}°; it must stay below {2}°: use at most {3}°</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>a shank of {0} mm is wider than the back face; use at most {1} mm</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>a smaller addendum factor, profile shift or pressure angle</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>a smaller fillet factor</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>a smaller fillet factor or deeper teeth</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>a smaller one</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>a smaller profile shift and backlash</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>a smaller profile shift or pressure angle</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>a spiral angle of {0}° on the {1} with an offset of {2} mm turns the {3}'s teeth against their hand, to {4}°; {5} or an offset of the other sign</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>a value of type {0}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>a whole number of more than 40 digits</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>a {0} flank reaches into the root; the variant is too inaccurate for this design to make a tooth of</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>addendum and dedendum angles of {0} leave {1} of the mean depth at an end of the face, less than {2}; use smaller ones, the standard taper or a smaller face width</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>an offset of {0} mm admits no pitch cones for these teeth, spiral angle and cutter</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>an offset of {0} mm leaves the pinion no face and root cone</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>another tooth depth or more teeth</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>base angle {0} rad is outside (0, pi/2)</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>best fit</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>body {0}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>choosing faces</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>closed valid </source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>collecting the gear</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>contact on the {0}'s {1} flank starts below its root cone</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>continuing the flanks</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>cutting of the {0}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>cutting the tooth spaces left {0} solids instead of one</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>cutting tooth spaces {0} to {1} of {2}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>does not reach everywhere: {0}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>face angle {0}° and root angle {1}° of the wheel must lie between 0° and 90°; use smaller addendum and dedendum angles or the uniform taper</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>face {0} is not valid after reading back</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>films are written as .mp4 or .gif</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>format {0} is newer than this program understands; it reads format {1}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>format {0} is unknown; this program reads format {1}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>give the pair deeper teeth or a larger overlap</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>has nothing to mesh with at an end, where the wheel's tips lie inside its base cone</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>heel chamfer</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>heel end</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>instead of {0} µm at most</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>internal error: {0}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>is a folder</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>is undercut near the {0}, {1} mm from the pitch apex, polar angle {2}° (area ratio {3}, must exceed {4})</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>it failed to start {0} times; {1}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>it holds something that is not a number</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>it is a model of another gear, or its axis is not the z axis</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>it was made of another state of the design: {0} changed since</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>its result could not be read: {0}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>joining the faces</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>leaves the tip of its teeth {0} mm wide at the heel, less than {1} mm: they are pointed</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>leaves {0} mm of the tooth space at the foot of the flanks, less than {1} mm</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>left out</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>less than {0}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>lies {0} µm from theory instead of at most {1} µm</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>line {0} has {1} columns, where {2} or more are needed</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>line {0} has {1} column{2}; give x, y, z or x, y, z, nx, ny, nz, or name the columns in a header line</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>line {0}: {1} is not a finite number</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>line {0}: {1} is not a number</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>lower side</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>makes its micro-geometry rise by up to {0} µm per mm of the flank, more than {1}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>measuring the gaps</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>meets the wheel inside its base cone with its tips</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>meshing of the {0}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>missing in {0}; write format = {1} in the first line</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>more teeth</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>more than {0}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>more than {0}, up to {1}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>no construction {0}; use {1}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>no contact: at some turn no tooth of the pinion faces a flank of the wheel; {0}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>no fillet of {0} mm joins root and start of contact on the {1}'s {2} flank; use a smaller fillet factor or a larger clearance</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>no known format; use {0}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>no permission</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>no radius does with this spiral angle; use a spiral angle of at most {0}°</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>no radius does: use a narrower face width or a smaller spiral angle</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>no such preset; the nearest is {0}{1}; presets: {2}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>none of the {0} faces is a flank of this {1}; {2}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>of a pair only the part 'gear' is written, not {0}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>one line of up to {0} characters</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>pictures are written as .png or .jpg</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>pipe along the tooth trace</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>pitch angles {0}° and {1}°, spiral angles {2}° and {3}°</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>placing the tooth spaces</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>points along each side</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>points of the wheel's flank never touch the pinion</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>points {0} mm apart are too many; use {1} mm or more</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>polar angle lies inside the base cone: the involute does not exist there</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>psi, trace</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>recovery format {0} is not the {1} that this program reads</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>smaller amounts on both flanks of this member</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>some are flanks of a gear of the other hand</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>some are flanks of the {0}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>some are in {0}: give the file the right unit</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>studying {0}, {1}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>take less misalignment</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>taking points</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>taking points of {0}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the CAD kernel cannot read this as STEP</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the CAD kernel cannot read this as {0}; it may be cut off or damaged</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the CAD kernel could not write the STEP file</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the CAD kernel could not write the {0} file; the disk may be full</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the CAD kernel made no face of the surface ({0})</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the CAD process died each time it tried: {0}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the arc of {0} mm does not cross {1} from {2} to {3} mm at less than {4}°; {5}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the conjugate flank has no point where one was asked for; it is undercut or too short there</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the disk is full</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the disk is read-only</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the disk quota is used up</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the disk reports a fault</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the edge of a chamfer at the end of the teeth could not be followed</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the file is gone; its record is still there</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the file is not as it was written: its checksum is another</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the file is too large for this disk</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the fillet of a hypoid tooth could not be found</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the fillets of neighbouring {0} teeth overlap; use a smaller fillet factor</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the film could not be encoded</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the film could not be encoded; the disk may be full</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the flank is undercut below the start of contact</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the flank's curvature is infinite on the base cone; take points above it</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the flanks of neighbouring {0} teeth meet above the root cone</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the flanks' normal pressure angles would be {0}° and {1}°, outside 0° to 45°; use a factor of at most {2}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the gear's axis lies along {0}, turn it to +z</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the header names no column {0}; it needs x, y and z</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the header says {0}; convert the points to mm</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the heel</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the job could not be sent: {0}: {1}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the kernel could not cut the tooth spaces from the blank</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the kernel's interpolation of the points failed</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the kernel's {0} failed: {1}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the kernel's {0} gave {1} faces where one was expected</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the name is too long</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the order of convergence takes three constructions or more</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the part {0} is not offered; parts: {1}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the pinion's {0} flank {1}; {2}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the points do not lie on this {0}'s flanks: {1} mm rms are left after the best fit, where {2} mm could be a measured deviation; {3}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the points do not tell turning and shifting apart; measure more of the flanks or fix one of the two</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the points look as if they were in {0}: multiplied by {1} they lie on the {2}'s teeth; convert them to mm</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the recursion of ISO 23509 Method 1 finds no pitch cones for this pair</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the root of the pinion</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the root of the wheel</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the solid is not closed</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the solid is not valid</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the standard taper</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the start of contact does not reach over the pinion's whole face; the pair is undercut there</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the surface has no tangent plane somewhere; it is folded or starts on the base cone</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the teeth up to their heel corners</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the tilted root line</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the tip of the pinion</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the tip of the wheel</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the toe</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the volume differs by {0}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the web's front face, {0} mm from the apex, must lie on the front cone between {1} and {2} mm; change the thickness by {3} mm</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the wheel's cone of {0}° leaves the pinion no cone to match; use smaller addendum and dedendum angles, the uniform taper or a smaller shaft angle</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the whole face width</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the {0} could not be fitted within {1} µm (got {2} µm)</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the {0} misses its limits by {1} mm and cannot be continued that far; the variant is too inaccurate for this design to make a tooth of</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the {0}'s teeth are pointed ({1} mm at the tip); {2}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the {0}'s teeth are pointed below their face cone</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the {0}'s {1} flank meets its base cone along its fillet; use another fillet factor</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the {0}'s {1} {2}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>there are no faces in it; points can be taken from solids and surfaces only</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>there are no points in it</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>there is a file where the folder should be</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>there is a folder of this name</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>there is no such file</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>there is no such file or folder</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>these values make no gear: {0}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>they are of another gear (number of teeth, spiral angle, hand)</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>they are of another gear, or the origin is not at the apex and z not along the axis</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>they fit a gear of the other hand</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>they fit the {0}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>this is a device, not a file</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>this is a folder, not a file</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>this is no complete {0} file; it may be cut off or damaged</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>this is no record of an export, or a damaged one; export again</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>this is no recovery file of GearStudio ({0})</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>this is not a file name</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>this is not the {0} {1} of this design: what is in it fills {2} mm</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>this misalignment takes {0} mm of backlash that the pair does not have: the teeth jam; give more backlash</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>toe chamfer</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>toe end</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>tooth {0} {1}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>triangles lie {0} µm from the surfaces {1}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>triangles within {0} mm and {1}° of the {2} would be more than {3} million; allow a larger distance or angle</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>turning the blank</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>unexpected error: {0}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>unknown key; the nearest known one is {0}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>unknown spacing {0}; use one of {1}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>use a depth factor of {0} with a mean addendum factor of {1}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>use a mean addendum factor of {0} (a profile shift of the pinion of {1})</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>use a pressure angle of {0}° with a mean addendum factor of {1}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>use a smaller offset</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>use a smaller offset or face width</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>use a spiral angle of at least {0}°</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>use at least {0} mm</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>use at most {0} mm</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>use more pinion teeth or a larger spiral angle</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>use {0}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>whole number</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>with an offset each member has a transverse pressure angle of its own; give the normal one</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>with an offset the spiral angle is given at the mean point; use mean</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>writing {0}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} MB is too large for a design file; the most is 1 MB</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} after reading the file back</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} cannot be a {1}; {2}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} cannot be written as {1}; formats: {2}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} is above the most of {1}{2}; {3}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} is below the least of {1}{2}; {3}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} is more than the wheel's {1} teeth; the pinion is the member with fewer: exchange them</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} is not a design; a design is a table of keys</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} is not a finite number; {1}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} is not a format number; write format = {1}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} is not a table; write [{1}] and its keys below it</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} is not a whole number; {1}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} is not a {1}; {2}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} is not above {1}{2}; {3}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} is not one of the choices; {1}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} is too narrow to make a tooth; use at least {1}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} leaves a member no addendum at the mean point; use a smaller profile shift or a larger addendum factor</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} leaves the {1} no {2} ({3} mm): its teeth do not reach across the pitch cone; use {4}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} leaves the {1}'s teeth no thickness at the pitch cone; use {2}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} lets the {1}'s fillet reach into the flank that meets the mate's tip; use {2}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} lets the {1}'s tip reach below the {2}'s base cone, where no conjugate flank is: the teeth interfere there; use {3}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} makes the contact ratio only {1}: a pair of teeth parts before the next one meets; a larger addendum factor, spiral angle or face width raises it</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} makes the {1}'s fillet reach its tip: no flank is left; use {2}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} makes the {1}'s fillets overlap: its root is rounded fully, with a radius of {2} mm instead of {3} mm; use {4} to keep a root land</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} makes the {1}'s flanks meet below its tip cone: the teeth are pointed; use {2}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} makes the {1}'s teeth touch each other at the foot: there is no tooth space; use {2}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} makes the {1}'s tip only {2} mm wide at the heel, less than {3} modules; a smaller addendum factor or profile shift makes it wider</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} measured points are too few; a best fit takes 3 or more</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} mm is more than half the outer cone distance of {1} mm; use at most {2} mm</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} mm is too narrow to make a tooth at an outer cone distance of {1} mm; use at least {2} mm</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} of the points lie beside the {1}'s teeth: they are {2} to {3} mm from the apex and at {4}° to {5}° from the axis, its flanks at {6} to {7} mm and {8}° to {9}°; {10}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} puts the {1}'s root cone at {2}°, and it must be above 0°; use {3}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} puts the {1}'s tip at {2}° to {3}° along the face and leaves no involute flank above its {4} cone of {5}°; use {6}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} solids instead of {1} were found</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} tooth of the {1}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} tooth space</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} tooth's lower side</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} {1} flank, cut off at its limits,</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} {1} of at {2} {3}{4}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} {1}solid{2}, {3} faces, {4} mm³ (relative difference {5})</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} µm on the {1}'s {2} flank {3}; use {4}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0} µm remained with {1} nodes where a step of the construction needs {2} µm; raise methods.tolerance_um</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0}: a number in it has thousands of digits</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0}: line {1} is not UTF-8 text; save the file as UTF-8</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0}: not a TOML file: tables or lists are nested too deeply</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0}: not a TOML file: {1}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0}: the file is empty; a design file begins with format = {1}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0}: the flanks touch on {1}: edge contact; less misalignment or more crowning avoids it</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0}: {1} failed: {2}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0}° at the toe makes the mean spiral angle more than {1}°; use {2}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0}° gives the {1} a pitch cone of {2}°, and it must stay below 90°; use at most {3}°, or numbers of teeth nearer to each other</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{0}° makes the {1}'s face cone, {2}°, open backwards (above 90°) as that of an internal gear; a smaller shaft angle avoids it</source>
   <translation type="unfinished" />
  </message>
 </context>
</TS>
