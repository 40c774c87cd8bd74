<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
 <context>
  <name>GearStudio</name>
  <message>
   <source> (+ {count} beside)</source>
   <translation>（另有 {count} 个在外）</translation>
  </message>
  <message>
   <source> and </source>
   <translation>和</translation>
  </message>
  <message>
   <source> or </source>
   <translation>或</translation>
  </message>
  <message>
   <source>&amp;About GearStudio</source>
   <translation>关于 GearStudio(&amp;A)</translation>
  </message>
  <message>
   <source>&amp;Back</source>
   <translation>上一步(&amp;B)</translation>
  </message>
  <message>
   <source>&amp;Backups…</source>
   <translation>备份(&amp;B)…</translation>
  </message>
  <message>
   <source>&amp;Cancel</source>
   <translation>取消(&amp;C)</translation>
  </message>
  <message>
   <source>&amp;Clear the list</source>
   <translation>清空列表(&amp;C)</translation>
  </message>
  <message>
   <source>&amp;Copy</source>
   <translation>复制(&amp;C)</translation>
  </message>
  <message>
   <source>&amp;Copy picture and numbers</source>
   <translation>复制图片和数据(&amp;C)</translation>
  </message>
  <message>
   <source>&amp;Differences only</source>
   <translation>仅差异(&amp;D)</translation>
  </message>
  <message>
   <source>&amp;Discard recovered</source>
   <translation>丢弃恢复版本(&amp;D)</translation>
  </message>
  <message>
   <source>&amp;Display panel</source>
   <translation>显示面板(&amp;D)</translation>
  </message>
  <message>
   <source>&amp;Done</source>
   <translation>完成(&amp;D)</translation>
  </message>
  <message>
   <source>&amp;Edit</source>
   <translation>编辑(&amp;E)</translation>
  </message>
  <message>
   <source>&amp;Equations</source>
   <translation>公式(&amp;E)</translation>
  </message>
  <message>
   <source>&amp;Export…</source>
   <translation>导出(&amp;E)…</translation>
  </message>
  <message>
   <source>&amp;File</source>
   <translation>文件(&amp;F)</translation>
  </message>
  <message>
   <source>&amp;Film…</source>
   <translation>影片(&amp;F)…</translation>
  </message>
  <message>
   <source>&amp;Find a parameter</source>
   <translation>查找参数(&amp;F)</translation>
  </message>
  <message>
   <source>&amp;Full screen</source>
   <translation>全屏(&amp;F)</translation>
  </message>
  <message>
   <source>&amp;Generating line on</source>
   <translation>母线位于(&amp;G)</translation>
  </message>
  <message>
   <source>&amp;Go back to this one</source>
   <translation>回到此版本(&amp;G)</translation>
  </message>
  <message>
   <source>&amp;Guide</source>
   <translation>指南(&amp;G)</translation>
  </message>
  <message>
   <source>&amp;Help</source>
   <translation>帮助(&amp;H)</translation>
  </message>
  <message>
   <source>&amp;Keep this one</source>
   <translation>保留当前版本(&amp;K)</translation>
  </message>
  <message>
   <source>&amp;Keys…</source>
   <translation>快捷键(&amp;K)…</translation>
  </message>
  <message>
   <source>&amp;Layers</source>
   <translation>图层(&amp;L)</translation>
  </message>
  <message>
   <source>&amp;Model</source>
   <translation>模型(&amp;M)</translation>
  </message>
  <message>
   <source>&amp;New</source>
   <translation>新建(&amp;N)</translation>
  </message>
  <message>
   <source>&amp;Next</source>
   <translation>下一步(&amp;N)</translation>
  </message>
  <message>
   <source>&amp;Open design…</source>
   <translation>打开设计(&amp;O)…</translation>
  </message>
  <message>
   <source>&amp;Open…</source>
   <translation>打开(&amp;O)…</translation>
  </message>
  <message>
   <source>&amp;Panels</source>
   <translation>面板(&amp;P)</translation>
  </message>
  <message>
   <source>&amp;Preferences…</source>
   <translation>首选项(&amp;P)…</translation>
  </message>
  <message>
   <source>&amp;Quit</source>
   <translation>退出(&amp;Q)</translation>
  </message>
  <message>
   <source>&amp;Rebuild</source>
   <translation>重新构建(&amp;R)</translation>
  </message>
  <message>
   <source>&amp;Redo</source>
   <translation>重做(&amp;R)</translation>
  </message>
  <message>
   <source>&amp;Report…</source>
   <translation>报告(&amp;R)…</translation>
  </message>
  <message>
   <source>&amp;Reset layout</source>
   <translation>重置布局(&amp;R)</translation>
  </message>
  <message>
   <source>&amp;Reset settings…</source>
   <translation>重置设置(&amp;R)…</translation>
  </message>
  <message>
   <source>&amp;Samples</source>
   <translation>示例(&amp;S)</translation>
  </message>
  <message>
   <source>&amp;Save</source>
   <translation>保存(&amp;S)</translation>
  </message>
  <message>
   <source>&amp;Save PDF…</source>
   <translation>保存 PDF(&amp;S)…</translation>
  </message>
  <message>
   <source>&amp;Save…</source>
   <translation>保存(&amp;S)…</translation>
  </message>
  <message>
   <source>&amp;Show equation</source>
   <translation>显示公式(&amp;S)</translation>
  </message>
  <message>
   <source>&amp;Stop</source>
   <translation>停止(&amp;S)</translation>
  </message>
  <message>
   <source>&amp;Take the file</source>
   <translation>采用文件(&amp;T)</translation>
  </message>
  <message>
   <source>&amp;Theme</source>
   <translation>主题(&amp;T)</translation>
  </message>
  <message>
   <source>&amp;Tour</source>
   <translation>导览(&amp;T)</translation>
  </message>
  <message>
   <source>&amp;Undo</source>
   <translation>撤销(&amp;U)</translation>
  </message>
  <message>
   <source>&amp;Undock</source>
   <translation>浮动(&amp;U)</translation>
  </message>
  <message>
   <source>&amp;Update preview</source>
   <translation>更新预览(&amp;U)</translation>
  </message>
  <message>
   <source>&amp;View</source>
   <translation>视图(&amp;V)</translation>
  </message>
  <message>
   <source>&amp;View all</source>
   <translation>全部显示(&amp;V)</translation>
  </message>
  <message>
   <source>&amp;What is this?</source>
   <translation>这是什么？(&amp;W)</translation>
  </message>
  <message>
   <source>, offset {offset} mm</source>
   <translation>，偏置距 {offset} mm</translation>
  </message>
  <message>
   <source>1 problem</source>
   <translation>1 个问题</translation>
  </message>
  <message>
   <source>1 warning</source>
   <translation>1 个警告</translation>
  </message>
  <message>
   <source>10/41 teeth with an offset of 38.1 mm, nearly a third of the wheel's radius</source>
   <translation>10/41 齿，偏置 38.1 mm，近大轮半径的三分之一</translation>
  </message>
  <message>
   <source>11/41 teeth with an offset of 25.4 mm: a rear axle whose pinion lies below the wheel's axis</source>
   <translation>11/41 齿，偏置 25.4 mm：小轮位于大轮轴线下方的后桥</translation>
  </message>
  <message>
   <source>13/37 teeth with an offset of 15 mm and shafts at 80°</source>
   <translation>13/37 齿，偏置 15 mm，轴交角 80°</translation>
  </message>
  <message>
   <source>13/42 teeth with an offset of −10 mm: the pinion's spiral angle is the smaller one, and its cone the slimmer</source>
   <translation>13/42 齿，偏置 −10 mm：小轮螺旋角较小，锥更细</translation>
  </message>
  <message>
   <source>14/35 teeth at 110°: a nearly flat wheel, and the same spiral angle everywhere on the face</source>
   <translation>14/35 齿，110°：大轮近乎平面，整个齿宽上螺旋角相同</translation>
  </message>
  <message>
   <source>14/39 teeth after ISO 23509: the same depth from toe to heel, for gears that one cutter head finishes</source>
   <translation>14/39 齿，按 ISO 23509：小端到大端等高，由同一刀盘完成</translation>
  </message>
  <message>
   <source>15/45 teeth, 28° spiral everywhere, sphere ends as in the paper</source>
   <translation>15/45 齿，各处螺旋角 28°，端面为球面（同论文）</translation>
  </message>
  <message>
   <source>16/32 teeth without spiral: teeth on straight lines to the apex, long and short addendum</source>
   <translation>16/32 齿，无螺旋：齿沿直线指向锥顶，齿顶高不等</translation>
  </message>
  <message>
   <source>17/40 teeth at 90° with a cutter arc of 80 mm and 35° spiral; the pinion's root lies inside its base cone</source>
   <translation>17/40 齿，90°，刀盘半径 80 mm，螺旋角 35°；小轮齿根位于基锥内</translation>
  </message>
  <message>
   <source>18/27 teeth at 45°: slender cones, long cone distance</source>
   <translation>18/27 齿，45°：细长锥体，锥距大</translation>
  </message>
  <message>
   <source>19/43 teeth of module 20 mm, outer cone distance near half a metre</source>
   <translation>19/43 齿，模数 20 mm，外锥距近半米</translation>
  </message>
  <message>
   <source>20/60 teeth of module 0.5 mm</source>
   <translation>20/60 齿，模数 0.5 mm</translation>
  </message>
  <message>
   <source>25/50 teeth curved by the cutter, but with no spiral angle at the mean point; shaft angle 75°</source>
   <translation>25/50 齿，由刀盘弯曲，但中点螺旋角为零；轴交角 75°</translation>
  </message>
  <message>
   <source>3D</source>
   <translation>3D</translation>
  </message>
  <message>
   <source>3D views drawn by</source>
   <translation>3D 视图绘制方式</translation>
  </message>
  <message>
   <source>3MF unit</source>
   <translation>3MF 单位</translation>
  </message>
  <message>
   <source>7 × 7 points inside the flank: root to tip, then on towards the heel</source>
   <translation>齿面内 7 × 7 点：由齿根到齿顶，再移向大端</translation>
  </message>
  <message>
   <source>9/37 teeth on a wheel of 420 mm with an offset of 40 mm; teeth of a tapering depth with a tilted root line</source>
   <translation>9/37 齿，大轮 420 mm，偏置 40 mm；收缩齿，倾斜齿根线</translation>
  </message>
  <message>
   <source>: not measured</source>
   <translation>：未测量</translation>
  </message>
  <message>
   <source>; equation {printed} of the paper</source>
   <translation>；论文公式 {printed}</translation>
  </message>
  <message>
   <source>A NURBS surface through discrete points on U and V lines</source>
   <translation>通过 U、V 线上离散点的 NURBS 曲面</translation>
  </message>
  <message>
   <source>A circle on the sphere, tangent to root and flank (or to the meridian below the base cone); it scales with ρ. The paper's factor f is 0.3.</source>
   <translation>球面上与齿根和齿面（基锥以下为子午线）相切的圆；随 ρ 缩放。论文的系数 f 为 0.3。</translation>
  </message>
  <message>
   <source>A click shows this method and variant; Ctrl+C copies the rows chosen</source>
   <translation>单击显示该方法与方案；Ctrl+C 复制所选行</translation>
  </message>
  <message>
   <source>A cube too, from where it ends down to the flank's lower edge; a_r is the share of the depth there.</source>
   <translation>同为三次函数，从终点向下到齿面下边缘； a_r 为该处占齿面高度的份额。</translation>
  </message>
  <message>
   <source>A cube, so that slope and curvature have no kink where it starts; a_t is the share of the depth there.</source>
   <translation>三次函数，使起点处斜率和曲率没有折角； a_t 为该处占齿面高度的份额。</translation>
  </message>
  <message>
   <source>A few letters are enough; Up and Down choose, Enter carries out</source>
   <translation>几个字母即可；上下键选择，回车执行</translation>
  </message>
  <message>
   <source>A mark shows where the paper prints something else</source>
   <translation>标记处表示论文印的不同</translation>
  </message>
  <message>
   <source>A misprint under the root: the spherical right triangle gives cos²δ.</source>
   <translation>根号下有印刷错误：球面直角三角形给出 cos²δ。</translation>
  </message>
  <message>
   <source>A number above 0, at most {most}</source>
   <translation>大于 0 且不超过 {most} 的数</translation>
  </message>
  <message>
   <source>A part of GearStudio could not be loaded: {text}</source>
   <translation>GearStudio 的一部分无法加载：{text}</translation>
  </message>
  <message>
   <source>A picture is missing: {reason}</source>
   <translation>缺少一幅图：{reason}</translation>
  </message>
  <message>
   <source>A point is turned about the axis by as much as moves it by e along the flank's normal: the flank stays explicit in azimuth. The methods build this flank, and deviation is from it.</source>
   <translation>将点绕轴转动，使其沿齿面法线移动 e：齿面仍以方位角显式表达。各方法构建此齿面，偏差也以它为准。</translation>
  </message>
  <message>
   <source>A point of the wheel's flank touches the pinion where its normal stands square to the relative velocity. That is linear in the cosine and the sine of its azimuth Φ: the envelope has a closed form.</source>
   <translation>大轮齿面上的点在其法线垂直于相对速度处与小轮接触。该条件对其方位角 Φ 的余弦和正弦是线性的：包络面有闭合形式。</translation>
  </message>
  <message>
   <source>A ratio that changes with n cannot be the count of points.</source>
   <translation>随 n 变化的比值不可能是点数。</translation>
  </message>
  <message>
   <source>A rear-axle ratio with few pinion teeth: strong profile shift, constant clearance, a little backlash</source>
   <translation>后桥传动比，小轮齿数少：变位大、等顶隙、少量侧隙</translation>
  </message>
  <message>
   <source>A reference: the pinion's flanks as involutes on base cones of their own</source>
   <translation>参考：小轮齿面为各自基锥上的渐开线</translation>
  </message>
  <message>
   <source>A round length; in perspective, of what is in the middle</source>
   <translation>取整的长度；透视时以中部为准</translation>
  </message>
  <message>
   <source>A section at ρ is turned by θ(ρ). ψ_t is the tooth trace's polar angle in the developed pitch plane, 0 at the mean point: of an Archimedean spiral, of the cutter's arc or of a logarithmic spiral. The hand is +1 for a right-hand spiral; the mate has the other.</source>
   <translation>ρ 处的截面转过 θ(ρ) 。 ψ_t 是齿线在展开节平面内的极角，中点处为 0：阿基米德螺旋线、刀盘圆弧或对数螺旋线。右旋时 hand 为 +1；配对轮相反。</translation>
  </message>
  <message>
   <source>A square marks a corner or the middle of an edge near by; a click takes that point</source>
   <translation>方框标出附近的角点或边的中点；单击即取该点</translation>
  </message>
  <message>
   <source>A turned copy is the same flank of another tooth.</source>
   <translation>旋转副本是另一齿的同一齿面。</translation>
  </message>
  <message>
   <source>A value with another unit can always be typed: 3in, {length}mm.</source>
   <translation>随时可以输入带其他单位的值：3in、{length}mm。</translation>
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
   <translation>AP242 为现行版本；AP214 和 AP203 供旧程序使用</translation>
  </message>
  <message>
   <source>About GearStudio</source>
   <translation>关于 GearStudio</translation>
  </message>
  <message>
   <source>About an axis through the centre of mass, square to the gear's axis</source>
   <translation>绕过质心且垂直于齿轮轴的轴</translation>
  </message>
  <message>
   <source>About the gear's axis</source>
   <translation>绕齿轮轴</translation>
  </message>
  <message>
   <source>Above this the CAD process is replaced when it is at rest; 0 for no limit</source>
   <translation>超过此值时 CAD 进程在空闲时被替换；0 表示不限</translation>
  </message>
  <message>
   <source>Acute shafts</source>
   <translation>锐角轴</translation>
  </message>
  <message>
   <source>Addendum angle</source>
   <translation>齿顶角</translation>
  </message>
  <message>
   <source>Addendum at the heel over outer module, before profile shift.</source>
   <translation>大端齿顶高与大端模数之比，变位前。</translation>
  </message>
  <message>
   <source>Addendum factor</source>
   <translation>齿顶高系数</translation>
  </message>
  <message>
   <source>Addendum, heel</source>
   <translation>齿顶高，大端</translation>
  </message>
  <message>
   <source>After a crash, edits since the last copy are lost</source>
   <translation>崩溃后，上次副本以来的修改会丢失</translation>
  </message>
  <message>
   <source>Against the effort</source>
   <translation>对应计算量</translation>
  </message>
  <message>
   <source>All can be told apart by colour-blind eyes</source>
   <translation>色觉障碍者也可区分</translation>
  </message>
  <message>
   <source>All files</source>
   <translation>所有文件</translation>
  </message>
  <message>
   <source>All methods and variants in a table</source>
   <translation>所有方法与方案的表格</translation>
  </message>
  <message>
   <source>All parameters are good</source>
   <translation>所有参数均有效</translation>
  </message>
  <message>
   <source>All points</source>
   <translation>所有点</translation>
  </message>
  <message>
   <source>All points of the generating line share the azimuth a of the line of contact: the plane is a rigid body.</source>
   <translation>母线各点与切线共有方位角 a：平面是刚体。</translation>
  </message>
  <message>
   <source>All teeth</source>
   <translation>所有齿</translation>
  </message>
  <message>
   <source>All three</source>
   <translation>全部三种</translation>
  </message>
  <message>
   <source>Along the axis, from the largest corner of the tip. t_z is how far the pitch apex lies beyond the crossing point; 0 without an offset.</source>
   <translation>沿轴线，从齿顶最大的角点起。 t_z 为节锥顶超出轴线交错点的距离；无偏置时为 0。</translation>
  </message>
  <message>
   <source>Along the face</source>
   <translation>沿齿宽</translation>
  </message>
  <message>
   <source>Along the face, at half the depth of the flank</source>
   <translation>沿齿宽，齿面高度一半处</translation>
  </message>
  <message>
   <source>Along the pitch circle at the heel; in the normal section at the mean point; the chord of that, which a gear tooth caliper measures.</source>
   <translation>大端节圆上的弧长；中点法截面内的弧长；以及其弦长，由齿厚卡尺测量。</translation>
  </message>
  <message>
   <source>Along the profile</source>
   <translation>沿齿廓</translation>
  </message>
  <message>
   <source>Along the profile, at the middle of the face</source>
   <translation>沿齿廓，齿宽中部</translation>
  </message>
  <message>
   <source>Aluminium</source>
   <translation>铝</translation>
  </message>
  <message>
   <source>Analysis</source>
   <translation>分析</translation>
  </message>
  <message>
   <source>Angle at most</source>
   <translation>最大角度</translation>
  </message>
  <message>
   <source>Angle between pitch and base element</source>
   <translation>节锥母线与基锥母线夹角</translation>
  </message>
  <message>
   <source>Angle between the two axes; both pitch cones must stay below 90°.</source>
   <translation>两轴夹角；两个节锥角均须小于 90°。</translation>
  </message>
  <message>
   <source>Another way to draw takes effect at the next start.</source>
   <translation>新的绘制方式在下次启动时生效。</translation>
  </message>
  <message>
   <source>Apex at the origin, axis along +z, teeth at z &gt; 0.</source>
   <translation>锥顶在原点，轴沿 +z，齿在 z &gt; 0。</translation>
  </message>
  <message>
   <source>Archimedean miter pair</source>
   <translation>阿基米德等齿数副</translation>
  </message>
  <message>
   <source>Archimedean spiral</source>
   <translation>阿基米德螺旋线</translation>
  </message>
  <message>
   <source>Archimedean: the paper's spiral on the base cone. Circular arc: the cutter's path. Logarithmic: the same spiral angle everywhere.</source>
   <translation>阿基米德：论文在基锥上的螺旋线。圆弧：刀盘轨迹。对数：各处螺旋角相同。</translation>
  </message>
  <message>
   <source>Arcs of the tip and root circles between the flanks.</source>
   <translation>齿面之间的顶圆和根圆弧。</translation>
  </message>
  <message>
   <source>Area</source>
   <translation>面积</translation>
  </message>
  <message>
   <source>Area of the pinion's flank over that of the wheel's which generates it; 0 is a cusp, less than 0 undercut. The numbers are the smallest of both flanks, and where.</source>
   <translation>小轮齿面面积与生成它的大轮齿面面积之比；0 为脊线，小于 0 为根切。数值为两侧齿面的最小值及其位置。</translation>
  </message>
  <message>
   <source>Arrows along the normals of the CAD flanks</source>
   <translation>沿 CAD 齿面法线的箭头</translation>
  </message>
  <message>
   <source>As an azimuth on the pitch cone, with profile shift x and transverse backlash j_t.</source>
   <translation>节锥上的方位角，含变位系数 x 和端面侧隙 j_t。</translation>
  </message>
  <message>
   <source>As it is</source>
   <translation>原值</translation>
  </message>
  <message>
   <source>As made</source>
   <translation>原样</translation>
  </message>
  <message>
   <source>As the paper has it, or refined until it meets the tolerance</source>
   <translation>同论文，或细化到满足公差</translation>
  </message>
  <message>
   <source>As the standard's recursion has it</source>
   <translation>按标准的递推</translation>
  </message>
  <message>
   <source>As the system</source>
   <translation>跟随系统</translation>
  </message>
  <message>
   <source>As the theme</source>
   <translation>跟随主题</translation>
  </message>
  <message>
   <source>As they are computed, in the order of the theory; beside a bar what the paper prints where that differs.</source>
   <translation>按实际计算所用的形式列出，顺序同理论；论文印刷形式不同之处列于竖线旁。</translation>
  </message>
  <message>
   <source>As {format}</source>
   <translation>存为 {format}</translation>
  </message>
  <message>
   <source>Assembled from its faces</source>
   <translation>由各面拼合</translation>
  </message>
  <message>
   <source>Assign</source>
   <translation>指定</translation>
  </message>
  <message>
   <source>At a cone distance R'; θ_a and θ_f lie between pitch cone and face cone, and pitch cone and root cone.</source>
   <translation>在锥距 R' 处； θ_a 和 θ_f 分别为节锥与面锥、节锥与根锥之间的角。</translation>
  </message>
  <message>
   <source>At the heel, square to the pitch cone; the profile shift x is the pinion's, the wheel has its negative.</source>
   <translation>在大端，垂直于节锥；变位系数 x 属于小轮，大轮取其负值。</translation>
  </message>
  <message>
   <source>At the mean point. With the outer module as depth system of a pair with an offset the factors are those that give the depths of the module at the wheel's heel.</source>
   <translation>在中点。有偏置的齿轮副采用大端模数齿高制时，这些系数使大轮大端得到由模数确定的齿高。</translation>
  </message>
  <message>
   <source>Auto</source>
   <translation>自动</translation>
  </message>
  <message>
   <source>Automatic</source>
   <translation>自动</translation>
  </message>
  <message>
   <source>Automatic range</source>
   <translation>自动范围</translation>
  </message>
  <message>
   <source>Automotive 9/41</source>
   <translation>汽车 9/41</translation>
  </message>
  <message>
   <source>Axes</source>
   <translation>坐标轴</translation>
  </message>
  <message>
   <source>Axial</source>
   <translation>轴向</translation>
  </message>
  <message>
   <source>Axial face width</source>
   <translation>轴向齿宽</translation>
  </message>
  <message>
   <source>Axial section of the blank; double-click to enlarge</source>
   <translation>轮坯轴截面；双击放大</translation>
  </message>
  <message>
   <source>Axis of the section</source>
   <translation>剖切轴</translation>
  </message>
  <message>
   <source>Azimuth</source>
   <translation>方位角</translation>
  </message>
  <message>
   <source>Azimuth, from where it started, of a point of the plane that rolls on the base cone without slip.</source>
   <translation>在基锥上纯滚动的平面上一点自起点起的方位角。</translation>
  </message>
  <message>
   <source>BREP as</source>
   <translation>BREP 格式</translation>
  </message>
  <message>
   <source>Back</source>
   <translation>后视</translation>
  </message>
  <message>
   <source>Back by a twelfth of a tooth</source>
   <translation>后退十二分之一齿</translation>
  </message>
  <message>
   <source>Back cone: as blanks are turned. Sphere: as in the paper.</source>
   <translation>背锥：如车削轮坯。球面：同论文。</translation>
  </message>
  <message>
   <source>Back cones</source>
   <translation>背锥</translation>
  </message>
  <message>
   <source>Background of the views</source>
   <translation>视图背景</translation>
  </message>
  <message>
   <source>Backlash</source>
   <translation>侧隙</translation>
  </message>
  <message>
   <source>Backups</source>
   <translation>备份</translation>
  </message>
  <message>
   <source>Base angle</source>
   <translation>基锥角</translation>
  </message>
  <message>
   <source>Base angle, coast flank</source>
   <translation>基锥角，反驱动面</translation>
  </message>
  <message>
   <source>Base angle, drive flank</source>
   <translation>基锥角，正驱动面</translation>
  </message>
  <message>
   <source>Base cone</source>
   <translation>基锥</translation>
  </message>
  <message>
   <source>Base cone angle</source>
   <translation>基锥角</translation>
  </message>
  <message>
   <source>Base cone spiral</source>
   <translation>基锥螺旋线</translation>
  </message>
  <message>
   <source>Base radius</source>
   <translation>基圆半径</translation>
  </message>
  <message>
   <source>Base radius, heel</source>
   <translation>基圆半径，大端</translation>
  </message>
  <message>
   <source>Base-cone spiral</source>
   <translation>基锥螺旋线</translation>
  </message>
  <message>
   <source>Best fit</source>
   <translation>最佳拟合</translation>
  </message>
  <message>
   <source>Between normals</source>
   <translation>法线夹角</translation>
  </message>
  <message>
   <source>Bevel pair of uniform depth</source>
   <translation>等高齿锥齿轮副</translation>
  </message>
  <message>
   <source>Bias</source>
   <translation>扭曲</translation>
  </message>
  <message>
   <source>Binary is five times smaller, text can be read</source>
   <translation>二进制小五倍，文本可读</translation>
  </message>
  <message>
   <source>Binary is smaller and quicker, text can be read</source>
   <translation>二进制更小更快，文本可读</translation>
  </message>
  <message>
   <source>Black</source>
   <translation>黑</translation>
  </message>
  <message>
   <source>Blank of the {member}</source>
   <translation>{member}轮坯</translation>
  </message>
  <message>
   <source>Blanks</source>
   <translation>轮坯</translation>
  </message>
  <message>
   <source>Blue – orange</source>
   <translation>蓝 – 橙</translation>
  </message>
  <message>
   <source>Borders of the flanks</source>
   <translation>齿面边界</translation>
  </message>
  <message>
   <source>Bore diameter</source>
   <translation>孔径</translation>
  </message>
  <message>
   <source>Both are the same.</source>
   <translation>两者相同。</translation>
  </message>
  <message>
   <source>Both cones touch at the mean point; ζ_m is the offset angle about the wheel's axis, ζ_mp that in the pitch plane. One number is left free, which the limit radius closes.</source>
   <translation>两锥在中点相切； ζ_m 为绕大轮轴的偏置角， ζ_mp 为节平面内的偏置角。剩下一个自由量，由极限半径确定。</translation>
  </message>
  <message>
   <source>Both flanks as the method made them, in one colour</source>
   <translation>方法生成的两侧齿面，单色</translation>
  </message>
  <message>
   <source>Both members</source>
   <translation>两轮</translation>
  </message>
  <message>
   <source>Both members have the same normal module, but not the same transverse one.</source>
   <translation>两轮的法向模数相同，端面模数不同。</translation>
  </message>
  <message>
   <source>Brass</source>
   <translation>黄铜</translation>
  </message>
  <message>
   <source>Bronze</source>
   <translation>青铜</translation>
  </message>
  <message>
   <source>Browse…</source>
   <translation>浏览…</translation>
  </message>
  <message>
   <source>Build</source>
   <translation>构建</translation>
  </message>
  <message>
   <source>Build &amp;gear</source>
   <translation>构建齿轮(&amp;G)</translation>
  </message>
  <message>
   <source>Build &amp;pair</source>
   <translation>构建齿轮副(&amp;P)</translation>
  </message>
  <message>
   <source>Build both gears and show them in mesh</source>
   <translation>构建两个齿轮并显示啮合</translation>
  </message>
  <message>
   <source>Build each method with growing effort; the design may be edited meanwhile</source>
   <translation>以递增计算量构建各方法；期间仍可修改设计</translation>
  </message>
  <message>
   <source>Build every variant again</source>
   <translation>重新构建所有方案</translation>
  </message>
  <message>
   <source>Build the solid of the design as it is now</source>
   <translation>按当前设计构建实体</translation>
  </message>
  <message>
   <source>Build the solids anew after every edit</source>
   <translation>每次修改后重建实体</translation>
  </message>
  <message>
   <source>Build the whole gear as a solid and show it</source>
   <translation>构建整个齿轮实体并显示</translation>
  </message>
  <message>
   <source>Building alone, both flanks</source>
   <translation>仅构建，两侧齿面</translation>
  </message>
  <message>
   <source>Building and checking</source>
   <translation>构建与检查</translation>
  </message>
  <message>
   <source>Building the {member} as a solid</source>
   <translation>正在构建实体：{member}</translation>
  </message>
  <message>
   <source>Building {method}, {variant}</source>
   <translation>正在构建 {method}，{variant}</translation>
  </message>
  <message>
   <source>Built in</source>
   <translation>构建用时</translation>
  </message>
  <message>
   <source>CAD flanks</source>
   <translation>CAD 齿面</translation>
  </message>
  <message>
   <source>CAD flanks coloured by deviation or curvature</source>
   <translation>按偏差或曲率着色的 CAD 齿面</translation>
  </message>
  <message>
   <source>CAD kernel busy</source>
   <translation>CAD 内核忙</translation>
  </message>
  <message>
   <source>CAD kernel ready</source>
   <translation>CAD 内核就绪</translation>
  </message>
  <message>
   <source>CAD kernel restarting…</source>
   <translation>CAD 内核重启中…</translation>
  </message>
  <message>
   <source>CAD kernel starting…</source>
   <translation>CAD 内核启动中…</translation>
  </message>
  <message>
   <source>CAD kernel stopped</source>
   <translation>CAD 内核已停止</translation>
  </message>
  <message>
   <source>CAD surface</source>
   <translation>CAD 曲面</translation>
  </message>
  <message>
   <source>CSV, .dat, or columns x y z and, if there are, nx ny nz, in mm; or a STEP file of the gear</source>
   <translation>CSV、.dat，或 x y z 列（可含 nx ny nz），单位 mm；或齿轮的 STEP 文件</translation>
  </message>
  <message>
   <source>Can be selected and copied</source>
   <translation>可选择并复制</translation>
  </message>
  <message>
   <source>Cancel</source>
   <translation>取消</translation>
  </message>
  <message>
   <source>Cancelled; Build builds it</source>
   <translation>已取消；点“构建”生成</translation>
  </message>
  <message>
   <source>Cancelled; Rebuild builds it</source>
   <translation>已取消；点“重新构建”生成</translation>
  </message>
  <message>
   <source>Cast iron</source>
   <translation>铸铁</translation>
  </message>
  <message>
   <source>Centre along face</source>
   <translation>沿齿宽的中心</translation>
  </message>
  <message>
   <source>Centre on profile</source>
   <translation>沿齿廓的中心</translation>
  </message>
  <message>
   <source>Centre z</source>
   <translation>质心 z</translation>
  </message>
  <message>
   <source>Change {field} to {value}</source>
   <translation>将{field}改为 {value}</translation>
  </message>
  <message>
   <source>Chapters</source>
   <translation>章节</translation>
  </message>
  <message>
   <source>Chart</source>
   <translation>图表</translation>
  </message>
  <message>
   <source>Charts</source>
   <translation>图表</translation>
  </message>
  <message>
   <source>Choose a command to change its keys</source>
   <translation>选择命令以更改快捷键</translation>
  </message>
  <message>
   <source>Choose a design</source>
   <translation>选择设计</translation>
  </message>
  <message>
   <source>Choose a design to compare with the one that is open.</source>
   <translation>选择一个设计与当前设计比较。</translation>
  </message>
  <message>
   <source>Choose a file format</source>
   <translation>选择文件格式</translation>
  </message>
  <message>
   <source>Choose a folder</source>
   <translation>选择文件夹</translation>
  </message>
  <message>
   <source>Choose another colour for this layer</source>
   <translation>为此图层选择其他颜色</translation>
  </message>
  <message>
   <source>Choose what goes in, then Update preview.</source>
   <translation>选择内容，然后更新预览。</translation>
  </message>
  <message>
   <source>Chordal addendum, mean</source>
   <translation>弦齿高，中点</translation>
  </message>
  <message>
   <source>Chordal addendum, outer</source>
   <translation>弦齿高，大端</translation>
  </message>
  <message>
   <source>Circular arc (milled)</source>
   <translation>圆弧（铣齿）</translation>
  </message>
  <message>
   <source>Circular plane of radius R that rolls on the base cone</source>
   <translation>在基锥上滚动的半径 R 圆平面</translation>
  </message>
  <message>
   <source>Clear</source>
   <translation>清空</translation>
  </message>
  <message>
   <source>Clear where nothing is; for slides and papers</source>
   <translation>空白处透明；用于幻灯片和论文</translation>
  </message>
  <message>
   <source>Clearance</source>
   <translation>顶隙</translation>
  </message>
  <message>
   <source>Clearance factor</source>
   <translation>顶隙系数</translation>
  </message>
  <message>
   <source>Clearance over depth</source>
   <translation>顶隙与齿高之比</translation>
  </message>
  <message>
   <source>Click into a table first</source>
   <translation>请先点击一个表格</translation>
  </message>
  <message>
   <source>Click the second point.</source>
   <translation>点击第二个点。</translation>
  </message>
  <message>
   <source>Click to see it in the view.</source>
   <translation>点击在视图中查看。</translation>
  </message>
  <message>
   <source>Click two points of the solid.</source>
   <translation>点击实体上的两个点。</translation>
  </message>
  <message>
   <source>Click two points: their distance and what lies between</source>
   <translation>点击两点：距离及其间的量</translation>
  </message>
  <message>
   <source>Close</source>
   <translation>关闭</translation>
  </message>
  <message>
   <source>Close the display panel</source>
   <translation>关闭显示面板</translation>
  </message>
  <message>
   <source>Close the report</source>
   <translation>关闭报告</translation>
  </message>
  <message>
   <source>Close without writing</source>
   <translation>关闭，不写出</translation>
  </message>
  <message>
   <source>Close; every choice is already in force</source>
   <translation>关闭；所有选择已生效</translation>
  </message>
  <message>
   <source>Close; nothing changes</source>
   <translation>关闭；不作更改</translation>
  </message>
  <message>
   <source>Close; what is being painted is given up</source>
   <translation>关闭；放弃正在绘制的内容</translation>
  </message>
  <message>
   <source>Closed</source>
   <translation>封闭</translation>
  </message>
  <message>
   <source>Co&amp;mpare with design…</source>
   <translation>与设计比较(&amp;M)…</translation>
  </message>
  <message>
   <source>Coarse</source>
   <translation>粗</translation>
  </message>
  <message>
   <source>Coarse mill drive</source>
   <translation>大模数磨机传动</translation>
  </message>
  <message>
   <source>Coast</source>
   <translation>反驱动</translation>
  </message>
  <message>
   <source>Colour and opacity of {layer}</source>
   <translation>{layer}的颜色和不透明度</translation>
  </message>
  <message>
   <source>Colour of the layer</source>
   <translation>图层颜色</translation>
  </message>
  <message>
   <source>Colour scale</source>
   <translation>色标</translation>
  </message>
  <message>
   <source>Coloured flanks</source>
   <translation>着色齿面</translation>
  </message>
  <message>
   <source>Colours</source>
   <translation>颜色</translation>
  </message>
  <message>
   <source>Colours of the members and of their flanks</source>
   <translation>各轮及其齿面的颜色</translation>
  </message>
  <message>
   <source>Colours of the window</source>
   <translation>窗口颜色</translation>
  </message>
  <message>
   <source>Colours, surface quality, cameras and ground of the views</source>
   <translation>视图的颜色、曲面质量、相机和背景</translation>
  </message>
  <message>
   <source>Colour…</source>
   <translation>颜色…</translation>
  </message>
  <message>
   <source>Combs</source>
   <translation>梳齿</translation>
  </message>
  <message>
   <source>Command</source>
   <translation>命令</translation>
  </message>
  <message>
   <source>Command &amp;palette…</source>
   <translation>命令面板(&amp;P)…</translation>
  </message>
  <message>
   <source>Command or parameter</source>
   <translation>命令或参数</translation>
  </message>
  <message>
   <source>Command palette</source>
   <translation>命令面板</translation>
  </message>
  <message>
   <source>Commands</source>
   <translation>命令</translation>
  </message>
  <message>
   <source>Commands and their keys</source>
   <translation>命令及其快捷键</translation>
  </message>
  <message>
   <source>Commands found</source>
   <translation>找到的命令</translation>
  </message>
  <message>
   <source>Common apex</source>
   <translation>共锥顶</translation>
  </message>
  <message>
   <source>Common apex: all cones share the apex, as in the paper. Constant clearance: the tip runs parallel to the mate's root.</source>
   <translation>共锥顶：各锥同顶，同论文。等顶隙：齿顶平行于配对轮齿根。</translation>
  </message>
  <message>
   <source>Compare designs</source>
   <translation>比较设计</translation>
  </message>
  <message>
   <source>Compare with design</source>
   <translation>与设计比较</translation>
  </message>
  <message>
   <source>Compare with the design of a file</source>
   <translation>与文件中的设计比较</translation>
  </message>
  <message>
   <source>Comparison</source>
   <translation>比较</translation>
  </message>
  <message>
   <source>Comparison of all methods and variants</source>
   <translation>所有方法与方案的比较</translation>
  </message>
  <message>
   <source>Compound</source>
   <translation>涂料</translation>
  </message>
  <message>
   <source>Compute the report of the design as it is now</source>
   <translation>计算当前设计的报告</translation>
  </message>
  <message>
   <source>Computed</source>
   <translation>计算值</translation>
  </message>
  <message>
   <source>Concave</source>
   <translation>凹面</translation>
  </message>
  <message>
   <source>Concave flank</source>
   <translation>凹齿面</translation>
  </message>
  <message>
   <source>Cones</source>
   <translation>锥体</translation>
  </message>
  <message>
   <source>Conjugate</source>
   <translation>共轭</translation>
  </message>
  <message>
   <source>Constant clearance</source>
   <translation>等顶隙</translation>
  </message>
  <message>
   <source>Constant slot width</source>
   <translation>等槽宽</translation>
  </message>
  <message>
   <source>Construction</source>
   <translation>构造</translation>
  </message>
  <message>
   <source>Contact</source>
   <translation>接触</translation>
  </message>
  <message>
   <source>Contact pattern</source>
   <translation>接触斑点</translation>
  </message>
  <message>
   <source>Contact pattern and transmission error, with misalignments</source>
   <translation>接触斑点与传动误差，含安装误差</translation>
  </message>
  <message>
   <source>Contact pattern on both members.</source>
   <translation>两轮上的接触斑点。</translation>
  </message>
  <message>
   <source>Contact pattern, ease-off and transmission error, drive and coast</source>
   <translation>接触斑点、Ease-off 与传动误差，正反驱动</translation>
  </message>
  <message>
   <source>Contact ratio</source>
   <translation>重合度</translation>
  </message>
  <message>
   <source>Contact ratios</source>
   <translation>重合度</translation>
  </message>
  <message>
   <source>Contact ratios with an offset</source>
   <translation>有偏置时的重合度</translation>
  </message>
  <message>
   <source>Contour lines</source>
   <translation>等值线</translation>
  </message>
  <message>
   <source>Contours</source>
   <translation>等值线</translation>
  </message>
  <message>
   <source>Contours every {step} µm; 0 at the mean point</source>
   <translation>每 {step} µm 一条等值线；中点为 0</translation>
  </message>
  <message>
   <source>Control points of the heavier flank</source>
   <translation>较复杂齿面的控制点</translation>
  </message>
  <message>
   <source>Control points of the surface, u × v</source>
   <translation>曲面控制点，u × v</translation>
  </message>
  <message>
   <source>Convergence</source>
   <translation>收敛</translation>
  </message>
  <message>
   <source>Convex</source>
   <translation>凸面</translation>
  </message>
  <message>
   <source>Convex flank</source>
   <translation>凸齿面</translation>
  </message>
  <message>
   <source>Copied the chart: picture and numbers</source>
   <translation>已复制图表：图像和数据</translation>
  </message>
  <message>
   <source>Copied the data sheet as {format}</source>
   <translation>已将数据表复制为 {format}</translation>
  </message>
  <message>
   <source>Copied the numbers of the chart; paste them into a spreadsheet</source>
   <translation>已复制图表数据；可粘贴到电子表格</translation>
  </message>
  <message>
   <source>Copied the picture of the chart</source>
   <translation>已复制图表图片</translation>
  </message>
  <message>
   <source>Copied; paste it into a spreadsheet</source>
   <translation>已复制；可粘贴到电子表格</translation>
  </message>
  <message>
   <source>Copies of the last saves, with what was different</source>
   <translation>最近保存的副本及其差异</translation>
  </message>
  <message>
   <source>Copy</source>
   <translation>复制</translation>
  </message>
  <message>
   <source>Copy &amp;derived values</source>
   <translation>复制推导值(&amp;D)</translation>
  </message>
  <message>
   <source>Copy &amp;diagnostics</source>
   <translation>复制诊断信息(&amp;D)</translation>
  </message>
  <message>
   <source>Copy &amp;numbers</source>
   <translation>复制数据(&amp;N)</translation>
  </message>
  <message>
   <source>Copy &amp;picture</source>
   <translation>复制图片(&amp;P)</translation>
  </message>
  <message>
   <source>Copy &amp;table</source>
   <translation>复制表格(&amp;T)</translation>
  </message>
  <message>
   <source>Copy all of the report</source>
   <translation>复制全部报告</translation>
  </message>
  <message>
   <source>Copy co&amp;mparison</source>
   <translation>复制比较表(&amp;M)</translation>
  </message>
  <message>
   <source>Copy of unsaved work after</source>
   <translation>未保存工作的副本延时</translation>
  </message>
  <message>
   <source>Copy report</source>
   <translation>复制报告</translation>
  </message>
  <message>
   <source>Copy table</source>
   <translation>复制表格</translation>
  </message>
  <message>
   <source>Copy the comparison table as text</source>
   <translation>将比较表复制为文本</translation>
  </message>
  <message>
   <source>Copy the derived values as text</source>
   <translation>将推导值复制为文本</translation>
  </message>
  <message>
   <source>Copy the entries that are shown</source>
   <translation>复制显示的条目</translation>
  </message>
  <message>
   <source>Copy the message with its details</source>
   <translation>复制消息及详情</translation>
  </message>
  <message>
   <source>Copy the picture and the numbers</source>
   <translation>复制图像和数据</translation>
  </message>
  <message>
   <source>Copy the picture to the clipboard</source>
   <translation>将图像复制到剪贴板</translation>
  </message>
  <message>
   <source>Copy the sheet</source>
   <translation>复制数据表</translation>
  </message>
  <message>
   <source>Copy the table for a spreadsheet</source>
   <translation>复制表格供电子表格使用</translation>
  </message>
  <message>
   <source>Copy the table with the focus, for a spreadsheet</source>
   <translation>复制焦点所在表格，供电子表格使用</translation>
  </message>
  <message>
   <source>Copy the values as a table</source>
   <translation>将数值复制为表格</translation>
  </message>
  <message>
   <source>Copy versions, design and log for a report</source>
   <translation>复制版本、设计和日志用于报告问题</translation>
  </message>
  <message>
   <source>Copy what is chosen in a table or text</source>
   <translation>复制表格或文本中的所选内容</translation>
  </message>
  <message>
   <source>Count</source>
   <translation>数量</translation>
  </message>
  <message>
   <source>Crown to apex</source>
   <translation>轮冠距</translation>
  </message>
  <message>
   <source>Crown to crossing point</source>
   <translation>轮冠至交错点</translation>
  </message>
  <message>
   <source>Curvature</source>
   <translation>曲率</translation>
  </message>
  <message>
   <source>Curvature combs</source>
   <translation>曲率梳</translation>
  </message>
  <message>
   <source>Curvature itself, or its difference to the exact flank</source>
   <translation>曲率本身，或与精确齿面之差</translation>
  </message>
  <message>
   <source>Curvature of the modelled flanks, as the paper's Fig. 11, or its difference to theory</source>
   <translation>模型齿面曲率（如论文图 11），或与理论之差</translation>
  </message>
  <message>
   <source>Curves along the tooth that guide the surface</source>
   <translation>沿齿向引导曲面的曲线</translation>
  </message>
  <message>
   <source>Custom</source>
   <translation>自定义</translation>
  </message>
  <message>
   <source>Cut</source>
   <translation>剪切</translation>
  </message>
  <message>
   <source>Cut from the blank (slow)</source>
   <translation>由轮坯切出（慢）</translation>
  </message>
  <message>
   <source>Cut square to the {axis} axis</source>
   <translation>垂直于 {axis} 轴剖切</translation>
  </message>
  <message>
   <source>Cutter radius</source>
   <translation>刀盘半径</translation>
  </message>
  <message>
   <source>D is the drive flank, concave on the pinion and convex on the wheel; C is the coast flank. Each flank of the wheel is a spherical involute on a base cone of its own.</source>
   <translation>D 为正驱动面，在小轮上为凹面，在大轮上为凸面；C 为反驱动面。大轮的每个齿面都是各自基锥上的球面渐开线。</translation>
  </message>
  <message>
   <source>Dark</source>
   <translation>深色</translation>
  </message>
  <message>
   <source>Dark – bright</source>
   <translation>暗 – 亮</translation>
  </message>
  <message>
   <source>Data sheet</source>
   <translation>数据表</translation>
  </message>
  <message>
   <source>Data sheet or published values</source>
   <translation>数据表或已发表的值</translation>
  </message>
  <message>
   <source>Decide &amp;later</source>
   <translation>稍后决定(&amp;L)</translation>
  </message>
  <message>
   <source>Decimals</source>
   <translation>小数位数</translation>
  </message>
  <message>
   <source>Dedendum angle</source>
   <translation>齿根角</translation>
  </message>
  <message>
   <source>Dedendum, heel</source>
   <translation>齿根高，大端</translation>
  </message>
  <message>
   <source>Default spiral bevel pair</source>
   <translation>默认弧齿锥齿轮副</translation>
  </message>
  <message>
   <source>Default: {value}</source>
   <translation>默认值：{value}</translation>
  </message>
  <message>
   <source>Degree</source>
   <translation>阶次</translation>
  </message>
  <message>
   <source>Degree of the surface through the point cloud.</source>
   <translation>点云曲面的阶次。</translation>
  </message>
  <message>
   <source>Degree of the surface, u × v</source>
   <translation>曲面阶次，u × v</translation>
  </message>
  <message>
   <source>Density</source>
   <translation>密度</translation>
  </message>
  <message>
   <source>Density of points</source>
   <translation>点密度</translation>
  </message>
  <message>
   <source>Density of the material in {unit}</source>
   <translation>材料密度，单位 {unit}</translation>
  </message>
  <message>
   <source>Depth</source>
   <translation>齿高</translation>
  </message>
  <message>
   <source>Depth after ISO 23509</source>
   <translation>ISO 23509 齿高</translation>
  </message>
  <message>
   <source>Depth factor</source>
   <translation>齿高系数</translation>
  </message>
  <message>
   <source>Depth system</source>
   <translation>齿高制</translation>
  </message>
  <message>
   <source>Depths</source>
   <translation>齿高</translation>
  </message>
  <message>
   <source>Depths along the tooth</source>
   <translation>沿齿向的齿高</translation>
  </message>
  <message>
   <source>Depths from the module</source>
   <translation>由模数确定的齿高</translation>
  </message>
  <message>
   <source>Derived values</source>
   <translation>推导值</translation>
  </message>
  <message>
   <source>Derived values of both members</source>
   <translation>两轮的推导值</translation>
  </message>
  <message>
   <source>Design</source>
   <translation>设计</translation>
  </message>
  <message>
   <source>Design in use</source>
   <translation>设计正在使用</translation>
  </message>
  <message>
   <source>Design, data sheets, comparison, maps, contact and equations as a PDF</source>
   <translation>设计、数据表、比较、云图、接触和公式，输出 PDF</translation>
  </message>
  <message>
   <source>Designs that were saved on this computer</source>
   <translation>在本机保存过的设计</translation>
  </message>
  <message>
   <source>Designs with unsaved work</source>
   <translation>有未保存工作的设计</translation>
  </message>
  <message>
   <source>Designs, backups and unsaved work stay. The old settings are kept as a .bak file.</source>
   <translation>设计、备份和未保存的工作保留。旧设置存为 .bak 文件。</translation>
  </message>
  <message>
   <source>Details</source>
   <translation>详情</translation>
  </message>
  <message>
   <source>Details of the message</source>
   <translation>消息详情</translation>
  </message>
  <message>
   <source>Deutsch</source>
   <translation>Deutsch</translation>
  </message>
  <message>
   <source>Deviation</source>
   <translation>偏差</translation>
  </message>
  <message>
   <source>Deviation against positions, sections or points, poles, and seconds</source>
   <translation>偏差对位置、截面或点数、控制点数及时间</translation>
  </message>
  <message>
   <source>Deviation along a series of points, as the paper's Fig. 12</source>
   <translation>沿点列的偏差，如论文图 12</translation>
  </message>
  <message>
   <source>Deviation along points, histogram</source>
   <translation>沿点的偏差、直方图</translation>
  </message>
  <message>
   <source>Deviation as a bar at each point, both flanks drawn flat</source>
   <translation>每点以柱表示偏差，两侧齿面展平</translation>
  </message>
  <message>
   <source>Deviation maps</source>
   <translation>偏差云图</translation>
  </message>
  <message>
   <source>Deviation of a point</source>
   <translation>点的偏差</translation>
  </message>
  <message>
   <source>Deviation of the CAD surface from the exact flank in µm, normal to it, over both flanks on a grid of 49 × 49 points that includes the edges. The paper states means of {means} µm for its own gear, whose data it does not print.</source>
   <translation>CAD 曲面相对精确齿面的法向偏差（µm），取两侧齿面上包含边缘的 49 × 49 点网格。论文给出其自身齿轮的平均值 {means} µm，但未印出该齿轮的数据。</translation>
  </message>
  <message>
   <source>Deviation, absolute</source>
   <translation>偏差，绝对值</translation>
  </message>
  <message>
   <source>Deviation, {kind}</source>
   <translation>偏差，{kind}</translation>
  </message>
  <message>
   <source>Deviations are normal to the flank, plus is metal added. Errors are those of all teeth of a flank together: of the spiral angle from toe to heel, of the pressure angle from root to tip, crowning as the height of the middle above the ends, the pitch as an arc of the mean pitch circle.</source>
   <translation>偏差沿齿面法向，正值表示多出材料。各项误差针对同侧齿面的全部轮齿：螺旋角误差由小端到大端，压力角误差由齿根到齿顶，鼓形量为中部高出两端的高度，齿距为中点分度圆上的弧长。</translation>
  </message>
  <message>
   <source>Deviations of all methods and variants, as a table and along the flank</source>
   <translation>所有方法与方案的偏差，表格及沿齿面</translation>
  </message>
  <message>
   <source>Deviations stay in µm and nm; the colour scale of the views has µin as well.</source>
   <translation>偏差始终用 µm 和 nm；视图的色标还可选 µin。</translation>
  </message>
  <message>
   <source>Diameter of a solid shank behind the back face, 0 for none; it replaces the bore.</source>
   <translation>背面后实心轴的直径，0 表示无；它取代内孔。</translation>
  </message>
  <message>
   <source>Diameter of the bore, 0 for none; leave empty to derive it from the pair.</source>
   <translation>孔径，0 表示无孔；留空则由齿轮副导出。</translation>
  </message>
  <message>
   <source>Diameters</source>
   <translation>直径</translation>
  </message>
  <message>
   <source>Difference</source>
   <translation>差值</translation>
  </message>
  <message>
   <source>Differences</source>
   <translation>差异</translation>
  </message>
  <message>
   <source>Differs from what is open in</source>
   <translation>与当前设计的差异</translation>
  </message>
  <message>
   <source>Digits after the point of lengths in mm and angles; two more in inches</source>
   <translation>mm 长度和角度的小数位；英寸多两位</translation>
  </message>
  <message>
   <source>Dimensions of both members with the standard's names</source>
   <translation>两轮尺寸，采用标准名称</translation>
  </message>
  <message>
   <source>Direction</source>
   <translation>方向</translation>
  </message>
  <message>
   <source>Direction of the curvature combs; the layer list switches them on</source>
   <translation>曲率梳的方向；在图层列表中打开</translation>
  </message>
  <message>
   <source>Direction of the lamps</source>
   <translation>灯的方向</translation>
  </message>
  <message>
   <source>Directions x, y and z of the gear</source>
   <translation>齿轮的 x、y、z 方向</translation>
  </message>
  <message>
   <source>Discard recovered</source>
   <translation>丢弃恢复版本</translation>
  </message>
  <message>
   <source>Dismiss</source>
   <translation>关闭</translation>
  </message>
  <message>
   <source>Display</source>
   <translation>显示</translation>
  </message>
  <message>
   <source>Display and work as for a new user; keys have a button of their own</source>
   <translation>显示与工作恢复为初始；快捷键另有按钮</translation>
  </message>
  <message>
   <source>Distance</source>
   <translation>距离</translation>
  </message>
  <message>
   <source>Distance between the axes of a hypoid pair; 0 is a bevel pair. Positive makes the pinion's spiral angle the larger one. With an offset the outer module and the face width are the wheel's.</source>
   <translation>准双曲面副的轴间距；0 为锥齿轮副。正值使小轮螺旋角较大。有偏置时，大端模数和齿宽属于大轮。</translation>
  </message>
  <message>
   <source>Do again what was taken back</source>
   <translation>重做已撤销的操作</translation>
  </message>
  <message>
   <source>Does not hold for this pair, which has an offset or a depth after ISO 23509.</source>
   <translation>不适用于此齿轮副：它有偏置或采用 ISO 23509 齿高。</translation>
  </message>
  <message>
   <source>Does not hold for this pair, which has no offset and depths from the module.</source>
   <translation>不适用于此齿轮副：它没有偏置，齿高由模数确定。</translation>
  </message>
  <message>
   <source>Does not hold for this pair, which has no offset.</source>
   <translation>不适用于此齿轮副：它没有偏置。</translation>
  </message>
  <message>
   <source>Does not hold for this pair, whose axes have an offset.</source>
   <translation>不适用于此齿轮副：其两轴有偏置。</translation>
  </message>
  <message>
   <source>Done again: {step}</source>
   <translation>已重做：{step}</translation>
  </message>
  <message>
   <source>Drag the card to where it hides nothing</source>
   <translation>将卡片拖到不遮挡处</translation>
  </message>
  <message>
   <source>Drag turns, the wheel zooms, a double click centres. Point at a flank to read its deviation there.</source>
   <translation>拖动旋转，滚轮缩放，双击居中。指向齿面即可读取该处偏差。</translation>
  </message>
  <message>
   <source>Draw deviations so many times as large, along the normal</source>
   <translation>沿法线方向按该倍数放大绘制偏差</translation>
  </message>
  <message>
   <source>Draw the CAD flanks with their deviation so many times as large, along the normal</source>
   <translation>沿法线方向按该倍数放大偏差来绘制 CAD 齿面</translation>
  </message>
  <message>
   <source>Draw the edges of the faces</source>
   <translation>绘制各面的边</translation>
  </message>
  <message>
   <source>Drawing by software failed too; install or update Mesa (libgl1-mesa-dri) or the driver.</source>
   <translation>软件绘制也失败；请安装或更新 Mesa (libgl1-mesa-dri) 或驱动程序。</translation>
  </message>
  <message>
   <source>Drive</source>
   <translation>正驱动</translation>
  </message>
  <message>
   <source>Duplex</source>
   <translation>双重收缩</translation>
  </message>
  <message>
   <source>E  offset</source>
   <translation>E  偏置</translation>
  </message>
  <message>
   <source>Each point P of the pinion, taken to the wheel, needs a turn q to touch. The smallest is the transmission error; what is left of the others is the gap g. Contact is where g is less than the marking compound's thickness.</source>
   <translation>小轮上的每个点 P 变换到大轮坐标后，需转动 q 才接触。最小的 q 即传动误差；其余的剩余量为间隙 g。g 小于涂料厚度处即为接触。</translation>
  </message>
  <message>
   <source>Each save leaves a copy. Going back changes no file until you save, and can be undone.</source>
   <translation>每次保存留一份副本。回退在保存前不改动文件，且可撤销。</translation>
  </message>
  <message>
   <source>Ease-off</source>
   <translation>Ease-off</translation>
  </message>
  <message>
   <source>Ease-off over the pinion's flanks; white throughout where the flanks are exactly conjugate.</source>
   <translation>小轮齿面上的 ease-off；齿面精确共轭处全为白色。</translation>
  </message>
  <message>
   <source>Edges</source>
   <translation>边</translation>
  </message>
  <message>
   <source>Effort</source>
   <translation>计算量</translation>
  </message>
  <message>
   <source>Empty the panel; the log file stays</source>
   <translation>清空面板；日志文件保留</translation>
  </message>
  <message>
   <source>Enclosed</source>
   <translation>所围体积</translation>
  </message>
  <message>
   <source>End chamfer</source>
   <translation>端部倒角</translation>
  </message>
  <message>
   <source>End of the scale</source>
   <translation>色标端点</translation>
  </message>
  <message>
   <source>End the CAD process and start a new one</source>
   <translation>结束 CAD 进程并重新启动</translation>
  </message>
  <message>
   <source>End the measurement</source>
   <translation>结束测量</translation>
  </message>
  <message>
   <source>English</source>
   <translation>English</translation>
  </message>
  <message>
   <source>Enter or a click carries out</source>
   <translation>回车或单击执行</translation>
  </message>
  <message>
   <source>Equations</source>
   <translation>公式</translation>
  </message>
  <message>
   <source>Error</source>
   <translation>误差</translation>
  </message>
  <message>
   <source>Errors</source>
   <translation>错误</translation>
  </message>
  <message>
   <source>Errors [µm]</source>
   <translation>误差 [µm]</translation>
  </message>
  <message>
   <source>Errors and statistics of the measured points</source>
   <translation>测点误差与统计</translation>
  </message>
  <message>
   <source>Esc</source>
   <translation>Esc</translation>
  </message>
  <message>
   <source>Even in the distance and in the polar angle; δ₀ is the flank's lower edge, on the root cone or the base cone. With an offset the pinion's flank begins at the start of contact.</source>
   <translation>按距离和极角均匀度量； δ₀ 为齿面下边缘，在根锥或基锥上。有偏置时小轮齿面从接触起点开始。</translation>
  </message>
  <message>
   <source>Evenly divided; by arc length or denser at the ends on request.</source>
   <translation>等分；也可按弧长或两端加密。</translation>
  </message>
  <message>
   <source>Every field of the design with symbol, value and unit</source>
   <translation>设计的每个字段及符号、数值、单位</translation>
  </message>
  <message>
   <source>Every file was read back after it was written, and held against the exact geometry.</source>
   <translation>每个文件写出后均已回读，并与精确几何对照。</translation>
  </message>
  <message>
   <source>Every formula, what the paper prints, and this design's numbers</source>
   <translation>每个公式、论文印刷形式及本设计的数值</translation>
  </message>
  <message>
   <source>Every method built with more and more positions, sections or points, and nothing else refined.</source>
   <translation>每种方法用越来越多的位置、截面或点构建，其余不作细化。</translation>
  </message>
  <message>
   <source>Every value of the pair; a row explains itself</source>
   <translation>齿轮副的每个值；点行可看说明</translation>
  </message>
  <message>
   <source>Every value of the pair; an offset makes it hypoid. Change one and everything follows, or its problem is told at its field. Shift+F1 explains a field, Ctrl+F1 shows its equation.</source>
   <translation>齿轮副的全部数值；有偏置即为准双曲面。改动一处，其余随之更新，或在字段旁显示问题。Shift+F1 说明字段，Ctrl+F1 显示其公式。</translation>
  </message>
  <message>
   <source>Everything</source>
   <translation>全部</translation>
  </message>
  <message>
   <source>Everything else works: parameters, comparison, charts, data sheets and exports.</source>
   <translation>其余功能正常：参数、比较、图表、数据表和导出。</translation>
  </message>
  <message>
   <source>Exaggerate</source>
   <translation>放大偏差</translation>
  </message>
  <message>
   <source>Expand the analysis</source>
   <translation>展开分析</translation>
  </message>
  <message>
   <source>Explain the parameter with the cursor, or what is clicked</source>
   <translation>说明光标所在参数或所点击的内容</translation>
  </message>
  <message>
   <source>Export</source>
   <translation>导出</translation>
  </message>
  <message>
   <source>Exporting {label}</source>
   <translation>正在导出 {label}</translation>
  </message>
  <message>
   <source>Exports</source>
   <translation>导出</translation>
  </message>
  <message>
   <source>Face and root cone angles</source>
   <translation>面锥角与根锥角</translation>
  </message>
  <message>
   <source>Face and root cone of the pinion</source>
   <translation>小轮的面锥与根锥</translation>
  </message>
  <message>
   <source>Face angle</source>
   <translation>面锥角</translation>
  </message>
  <message>
   <source>Face apex beyond crossing point</source>
   <translation>面锥顶至轴线交点</translation>
  </message>
  <message>
   <source>Face cone at constant clearance</source>
   <translation>等顶隙时的面锥</translation>
  </message>
  <message>
   <source>Face farthest from theory</source>
   <translation>偏离理论最大的面</translation>
  </message>
  <message>
   <source>Face width</source>
   <translation>齿宽</translation>
  </message>
  <message>
   <source>Face width along the pitch cone; leave empty to take the factor.</source>
   <translation>沿节锥的齿宽；留空则用系数。</translation>
  </message>
  <message>
   <source>Face width factor</source>
   <translation>齿宽系数</translation>
  </message>
  <message>
   <source>Face width from mean point to heel</source>
   <translation>中点至大端齿宽</translation>
  </message>
  <message>
   <source>Face width from mean point to toe</source>
   <translation>中点至小端齿宽</translation>
  </message>
  <message>
   <source>Face width over outer cone distance; a face width that is given wins over it.</source>
   <translation>齿宽与外锥距之比；给定的齿宽优先。</translation>
  </message>
  <message>
   <source>Faces</source>
   <translation>面</translation>
  </message>
  <message>
   <source>Faces joined into one shell, or tooth spaces cut from the blank by Booleans</source>
   <translation>各面拼成一个壳，或用布尔运算从轮坯切出齿槽</translation>
  </message>
  <message>
   <source>Field</source>
   <translation>字段</translation>
  </message>
  <message>
   <source>Fields that differ from their defaults; the context menu resets the group</source>
   <translation>与默认值不同的字段；右键菜单可重置该组</translation>
  </message>
  <message>
   <source>Fields with a problem</source>
   <translation>有问题的字段</translation>
  </message>
  <message>
   <source>File</source>
   <translation>文件</translation>
  </message>
  <message>
   <source>File changed</source>
   <translation>文件已更改</translation>
  </message>
  <message>
   <source>Files</source>
   <translation>文件</translation>
  </message>
  <message>
   <source>Files and help</source>
   <translation>文件与帮助</translation>
  </message>
  <message>
   <source>Fillet factor</source>
   <translation>齿根圆角系数</translation>
  </message>
  <message>
   <source>Fillet radius</source>
   <translation>齿根圆角半径</translation>
  </message>
  <message>
   <source>Fillet radius on the heel sphere over mean normal module.</source>
   <translation>大端球面上的圆角半径与中点法向模数之比。</translation>
  </message>
  <message>
   <source>Fillet radius, heel</source>
   <translation>齿根圆角半径，大端</translation>
  </message>
  <message>
   <source>Film</source>
   <translation>影片</translation>
  </message>
  <message>
   <source>Find a command or a key</source>
   <translation>查找命令或快捷键</translation>
  </message>
  <message>
   <source>Find a parameter</source>
   <translation>查找参数</translation>
  </message>
  <message>
   <source>Find an equation</source>
   <translation>查找公式</translation>
  </message>
  <message>
   <source>Find any command or parameter by a few letters</source>
   <translation>用几个字母查找任意命令或参数</translation>
  </message>
  <message>
   <source>Find in guide and glossary</source>
   <translation>在指南和术语表中查找</translation>
  </message>
  <message>
   <source>Fine</source>
   <translation>细</translation>
  </message>
  <message>
   <source>Fine instrument pair</source>
   <translation>小模数仪表副</translation>
  </message>
  <message>
   <source>Fit all</source>
   <translation>适合窗口</translation>
  </message>
  <message>
   <source>Flank</source>
   <translation>齿面</translation>
  </message>
  <message>
   <source>Flank colours</source>
   <translation>齿面颜色</translation>
  </message>
  <message>
   <source>Flanks are drawn with their deviation {factor}</source>
   <translation>齿面按偏差 {factor} 绘制</translation>
  </message>
  <message>
   <source>Flanks coloured by deviation</source>
   <translation>齿面按偏差着色</translation>
  </message>
  <message>
   <source>Flanks of one tooth</source>
   <translation>单齿齿面</translation>
  </message>
  <message>
   <source>Flanks of the pinion</source>
   <translation>小轮齿面</translation>
  </message>
  <message>
   <source>Flat: the flanks are conjugate</source>
   <translation>平坦：齿面共轭</translation>
  </message>
  <message>
   <source>Fold all groups</source>
   <translation>折叠所有组</translation>
  </message>
  <message>
   <source>Fold or unfold this group</source>
   <translation>折叠或展开此组</translation>
  </message>
  <message>
   <source>Folder</source>
   <translation>文件夹</translation>
  </message>
  <message>
   <source>Folder for the exported files</source>
   <translation>导出文件的文件夹</translation>
  </message>
  <message>
   <source>Folder not found</source>
   <translation>找不到文件夹</translation>
  </message>
  <message>
   <source>For the Archimedean spiral with β₀ at the toe; for other curves the same difference θ(R) − θ(R − B).</source>
   <translation>适用于小端为 β₀ 的阿基米德螺旋线；其他曲线用同样的差 θ(R) − θ(R − B)。</translation>
  </message>
  <message>
   <source>Forget layout, lists and preferences; designs stay</source>
   <translation>清除布局、列表和首选项；设计保留</translation>
  </message>
  <message>
   <source>Forget the edits that were not saved</source>
   <translation>丢弃未保存的修改</translation>
  </message>
  <message>
   <source>Forget the layout, the list of recent files and all preferences?</source>
   <translation>清除布局、最近文件列表和所有首选项？</translation>
  </message>
  <message>
   <source>Forget the unsaved edits of “{name}” for good?</source>
   <translation>永久丢弃“{name}”未保存的修改？</translation>
  </message>
  <message>
   <source>Formula</source>
   <translation>公式</translation>
  </message>
  <message>
   <source>Frames</source>
   <translation>帧率</translation>
  </message>
  <message>
   <source>Frames in a second</source>
   <translation>每秒帧数</translation>
  </message>
  <message>
   <source>From [{unit}]</source>
   <translation>从 [{unit}]</translation>
  </message>
  <message>
   <source>From the apex</source>
   <translation>从锥顶看</translation>
  </message>
  <message>
   <source>From the apex to the back face.</source>
   <translation>从锥顶到背面。</translation>
  </message>
  <message>
   <source>From the back face toward the apex; the toe limits it.</source>
   <translation>从背面向锥顶；以小端为限。</translation>
  </message>
  <message>
   <source>From the heel</source>
   <translation>从大端看</translation>
  </message>
  <message>
   <source>From the toe to the heel.</source>
   <translation>从小端到大端。</translation>
  </message>
  <message>
   <source>From the wheel's pitch cone to its face cone; leave empty to take the taper's.</source>
   <translation>大轮节锥到面锥；留空则按收缩方式。</translation>
  </message>
  <message>
   <source>From the wheel's root cone to its pitch cone; leave empty to take the taper's.</source>
   <translation>大轮根锥到节锥；留空则按收缩方式。</translation>
  </message>
  <message>
   <source>Front</source>
   <translation>前视</translation>
  </message>
  <message>
   <source>Front crown to apex</source>
   <translation>小端轮冠距</translation>
  </message>
  <message>
   <source>Front crown to crossing point</source>
   <translation>小端轮冠至交错点</translation>
  </message>
  <message>
   <source>G  wheel axial</source>
   <translation>G  大轮轴向</translation>
  </message>
  <message>
   <source>G&amp;lossary</source>
   <translation>术语表(&amp;L)</translation>
  </message>
  <message>
   <source>GLB unit</source>
   <translation>GLB 单位</translation>
  </message>
  <message>
   <source>GLB up</source>
   <translation>GLB 上方向</translation>
  </message>
  <message>
   <source>Gap</source>
   <translation>间隙</translation>
  </message>
  <message>
   <source>Gap between the flanks beyond that at the mean point, with contours</source>
   <translation>齿面间隙减去中点间隙，含等值线</translation>
  </message>
  <message>
   <source>Gaussian</source>
   <translation>高斯</translation>
  </message>
  <message>
   <source>Gaussian curvature</source>
   <translation>高斯曲率</translation>
  </message>
  <message>
   <source>Gaussian curvature of the surfaces and of theory</source>
   <translation>各曲面与理论的高斯曲率</translation>
  </message>
  <message>
   <source>Gear designs (*.gear.toml);;All files (*)</source>
   <translation>齿轮设计 (*.gear.toml);;所有文件 (*)</translation>
  </message>
  <message>
   <source>Gear ratio</source>
   <translation>齿数比</translation>
  </message>
  <message>
   <source>GearStudio ended unexpectedly. Of these designs it kept edits that were not saved.</source>
   <translation>GearStudio 意外结束。以下设计保留了未保存的修改。</translation>
  </message>
  <message>
   <source>Generating line</source>
   <translation>母线</translation>
  </message>
  <message>
   <source>Generation</source>
   <translation>生成</translation>
  </message>
  <message>
   <source>Geometry data sheet</source>
   <translation>几何数据表</translation>
  </message>
  <message>
   <source>Geometry of both members; every value explains itself</source>
   <translation>两轮几何；每个值都有说明</translation>
  </message>
  <message>
   <source>Give every command its usual keys</source>
   <translation>恢复所有命令的默认快捷键</translation>
  </message>
  <message>
   <source>Give every parameter its default back; can be undone</source>
   <translation>所有参数恢复默认；可撤销</translation>
  </message>
  <message>
   <source>Give the analysis the room of the 3D views</source>
   <translation>让分析占用 3D 视图的空间</translation>
  </message>
  <message>
   <source>Give the command its usual keys</source>
   <translation>恢复该命令的默认快捷键</translation>
  </message>
  <message>
   <source>Give the command these keys</source>
   <translation>将这些键指定给命令</translation>
  </message>
  <message>
   <source>Give the field with the cursor its default back</source>
   <translation>光标所在字段恢复默认</translation>
  </message>
  <message>
   <source>Give the film up; no file is left</source>
   <translation>放弃影片；不留文件</translation>
  </message>
  <message>
   <source>Glossary</source>
   <translation>术语表</translation>
  </message>
  <message>
   <source>Go back to one of the last saves</source>
   <translation>回到最近保存的某一版本</translation>
  </message>
  <message>
   <source>Go back to the save of {date}</source>
   <translation>回到 {date} 的保存</translation>
  </message>
  <message>
   <source>Go on</source>
   <translation>继续</translation>
  </message>
  <message>
   <source>Go on with the edits that were not saved</source>
   <translation>继续未保存的修改</translation>
  </message>
  <message>
   <source>Go to a heading</source>
   <translation>跳到标题</translation>
  </message>
  <message>
   <source>Go to the parameter in the window</source>
   <translation>转到窗口中的参数</translation>
  </message>
  <message>
   <source>Grey</source>
   <translation>灰</translation>
  </message>
  <message>
   <source>Greys</source>
   <translation>灰度</translation>
  </message>
  <message>
   <source>Ground</source>
   <translation>背景</translation>
  </message>
  <message>
   <source>Group</source>
   <translation>组</translation>
  </message>
  <message>
   <source>Guide</source>
   <translation>指南</translation>
  </message>
  <message>
   <source>Guide curve along the tip</source>
   <translation>沿齿顶的引导线</translation>
  </message>
  <message>
   <source>Guide curves</source>
   <translation>引导线</translation>
  </message>
  <message>
   <source>Guide curves follow the flank on tip and root.</source>
   <translation>引导线在齿顶和齿根处跟随齿面。</translation>
  </message>
  <message>
   <source>Guide or glossary</source>
   <translation>指南或术语表</translation>
  </message>
  <message>
   <source>Half the tooth's thickness</source>
   <translation>半齿厚</translation>
  </message>
  <message>
   <source>Half the tooth, azimuth on the pitch cone</source>
   <translation>半齿，节锥上的方位角</translation>
  </message>
  <message>
   <source>Hand of spiral</source>
   <translation>旋向</translation>
  </message>
  <message>
   <source>Hand of spiral of the pinion; the wheel has the other.</source>
   <translation>小轮旋向；大轮相反。</translation>
  </message>
  <message>
   <source>Hand of the pinion</source>
   <translation>小轮旋向</translation>
  </message>
  <message>
   <source>Headings</source>
   <translation>标题</translation>
  </message>
  <message>
   <source>Heel and toe profiles, sections and positions used</source>
   <translation>大小端齿廓、所用截面与位置</translation>
  </message>
  <message>
   <source>Highest deviation</source>
   <translation>最高偏差</translation>
  </message>
  <message>
   <source>Histogram</source>
   <translation>直方图</translation>
  </message>
  <message>
   <source>How a whole gear is put together</source>
   <translation>整个齿轮的构造方式</translation>
  </message>
  <message>
   <source>How far it lies beyond the crossing point; t_zm is the mean point's distance along the axis.</source>
   <translation>它超出轴线交错点的距离； t_zm 为中点沿轴线的距离。</translation>
  </message>
  <message>
   <source>How far the plane has rolled. It starts at 0 where the root lies below the base cone.</source>
   <translation>平面滚过的角度。齿根低于基锥处从 0 开始。</translation>
  </message>
  <message>
   <source>How far triangles may lie from the surfaces; left empty, 1e-4 of the outer cone distance</source>
   <translation>三角形偏离曲面的最大距离；留空为外锥距的 1e-4</translation>
  </message>
  <message>
   <source>How many colours</source>
   <translation>颜色数</translation>
  </message>
  <message>
   <source>How many points are taken of a CAD model's flanks</source>
   <translation>从 CAD 模型齿面取点的数量</translation>
  </message>
  <message>
   <source>How much of the layer one sees; as made, some layers are glass</source>
   <translation>图层的可见程度；有些本来就是透明的</translation>
  </message>
  <message>
   <source>How often which deviation occurs</source>
   <translation>各偏差出现的频率</translation>
  </message>
  <message>
   <source>How the value came about</source>
   <translation>该值的由来</translation>
  </message>
  <message>
   <source>How they are written</source>
   <translation>写出方式</translation>
  </message>
  <message>
   <source>How to use the studio</source>
   <translation>使用方法</translation>
  </message>
  <message>
   <source>Hub diameter</source>
   <translation>轮毂直径</translation>
  </message>
  <message>
   <source>Hub length</source>
   <translation>轮毂长度</translation>
  </message>
  <message>
   <source>Hypoid offset</source>
   <translation>准双曲面偏置</translation>
  </message>
  <message>
   <source>Hypoid, all-wheel drive at 80°</source>
   <translation>准双曲面，80° 全轮驱动</translation>
  </message>
  <message>
   <source>Hypoid, heavy truck</source>
   <translation>准双曲面，重型卡车</translation>
  </message>
  <message>
   <source>Hypoid, negative offset</source>
   <translation>准双曲面，负偏置</translation>
  </message>
  <message>
   <source>Hypoid, passenger car</source>
   <translation>准双曲面，乘用车</translation>
  </message>
  <message>
   <source>Hypoid, pick-up</source>
   <translation>准双曲面，皮卡</translation>
  </message>
  <message>
   <source>IGES bodies</source>
   <translation>IGES 实体</translation>
  </message>
  <message>
   <source>IGES unit</source>
   <translation>IGES 单位</translation>
  </message>
  <message>
   <source>ISO 23509</source>
   <translation>ISO 23509</translation>
  </message>
  <message>
   <source>ISO 23509:2016, sample F.2, spiral bevel pair 14/39</source>
   <translation>ISO 23509:2016，算例 F.2，弧齿锥齿轮副 14/39</translation>
  </message>
  <message>
   <source>In the chosen material</source>
   <translation>按所选材料</translation>
  </message>
  <message>
   <source>In the design file: {key}</source>
   <translation>设计文件中：{key}</translation>
  </message>
  <message>
   <source>In the glossary: {term}</source>
   <translation>术语表：{term}</translation>
  </message>
  <message>
   <source>Inches</source>
   <translation>英寸</translation>
  </message>
  <message>
   <source>Inertia x</source>
   <translation>惯量 x</translation>
  </message>
  <message>
   <source>Inertia z</source>
   <translation>惯量 z</translation>
  </message>
  <message>
   <source>Inner addendum</source>
   <translation>小端齿顶高</translation>
  </message>
  <message>
   <source>Inner clearance</source>
   <translation>小端顶隙</translation>
  </message>
  <message>
   <source>Inner cone distance</source>
   <translation>内锥距</translation>
  </message>
  <message>
   <source>Inner dedendum</source>
   <translation>小端齿根高</translation>
  </message>
  <message>
   <source>Inner pitch diameter</source>
   <translation>小端节圆直径</translation>
  </message>
  <message>
   <source>Inner root diameter</source>
   <translation>小端根圆直径</translation>
  </message>
  <message>
   <source>Inner spiral angle</source>
   <translation>小端螺旋角</translation>
  </message>
  <message>
   <source>Inner tip diameter</source>
   <translation>小端顶圆直径</translation>
  </message>
  <message>
   <source>Inner whole depth</source>
   <translation>小端全齿高</translation>
  </message>
  <message>
   <source>Isometric</source>
   <translation>等轴测</translation>
  </message>
  <message>
   <source>It could not be put aside.</source>
   <translation>无法将其移开。</translation>
  </message>
  <message>
   <source>It is kept as {file}.</source>
   <translation>已存为 {file}。</translation>
  </message>
  <message>
   <source>It needs a pair with an offset.</source>
   <translation>需要有偏置的齿轮副。</translation>
  </message>
  <message>
   <source>It needs “{choice}” as {field}.</source>
   <translation>需要{field}为“{choice}”。</translation>
  </message>
  <message>
   <source>Its version can be taken, and Undo brings this one back; or keep this one.</source>
   <translation>可采用文件版本（撤销可恢复当前），或保留当前版本。</translation>
  </message>
  <message>
   <source>KHK gear technical reference, Gleason spiral bevel pair 20/40</source>
   <translation>KHK 齿轮技术资料，格里森弧齿锥齿轮副 20/40</translation>
  </message>
  <message>
   <source>Keep a record of the check beside each file</source>
   <translation>在每个文件旁保存检查记录</translation>
  </message>
  <message>
   <source>Keep everything; File ▸ Recover unsaved work, or the next start, asks again</source>
   <translation>全部保留；“文件 ▸ 恢复未保存的工作”或下次启动会再询问</translation>
  </message>
  <message>
   <source>Key in the design file</source>
   <translation>设计文件中的键</translation>
  </message>
  <message>
   <source>Key in {table}</source>
   <translation>{table} 中的键</translation>
  </message>
  <message>
   <source>Keys</source>
   <translation>快捷键</translation>
  </message>
  <message>
   <source>Keys of all commands</source>
   <translation>所有命令的快捷键</translation>
  </message>
  <message>
   <source>Lamps</source>
   <translation>灯</translation>
  </message>
  <message>
   <source>Language</source>
   <translation>语言</translation>
  </message>
  <message>
   <source>Language of the report</source>
   <translation>报告语言</translation>
  </message>
  <message>
   <source>Largest</source>
   <translation>最大</translation>
  </message>
  <message>
   <source>Largest [µm]</source>
   <translation>最大 [µm]</translation>
  </message>
  <message>
   <source>Largest angle between neighbouring chords; left empty, the distance alone decides</source>
   <translation>相邻弦间最大角；留空则仅由距离决定</translation>
  </message>
  <message>
   <source>Largest between neighbouring faces</source>
   <translation>相邻面之间的最大值</translation>
  </message>
  <message>
   <source>Largest deviation against poles and seconds of each method</source>
   <translation>各方法的最大偏差对控制点数和时间</translation>
  </message>
  <message>
   <source>Largest deviation from the exact flank, over both flanks</source>
   <translation>与精确齿面的最大偏差，两侧齿面</translation>
  </message>
  <message>
   <source>Largest deviation over both flanks</source>
   <translation>两侧齿面的最大偏差</translation>
  </message>
  <message>
   <source>Largest deviation without its sign</source>
   <translation>最大偏差（绝对值）</translation>
  </message>
  <message>
   <source>Largest principal</source>
   <translation>最大主</translation>
  </message>
  <message>
   <source>Layers</source>
   <translation>图层</translation>
  </message>
  <message>
   <source>Leave it empty to use the derived value shown in grey.</source>
   <translation>留空则采用灰色显示的推导值。</translation>
  </message>
  <message>
   <source>Leave out what both designs have in common</source>
   <translation>略去两设计相同的部分</translation>
  </message>
  <message>
   <source>Leave the tour; Help ▸ Tour starts it again</source>
   <translation>离开导览；“帮助 ▸ 导览”可重新开始</translation>
  </message>
  <message>
   <source>Left</source>
   <translation>左视</translation>
  </message>
  <message>
   <source>Left hand</source>
   <translation>左旋</translation>
  </message>
  <message>
   <source>Length</source>
   <translation>长度</translation>
  </message>
  <message>
   <source>Length of the combs; teeth longer than three typical ones are cut off</source>
   <translation>梳齿长度；超过三倍典型长度的被截断</translation>
  </message>
  <message>
   <source>Length of the film</source>
   <translation>影片长度</translation>
  </message>
  <message>
   <source>Length of the shank behind the back face, 0 for none.</source>
   <translation>背面后轴的长度，0 表示无。</translation>
  </message>
  <message>
   <source>Lengths in</source>
   <translation>长度单位</translation>
  </message>
  <message>
   <source>Lengthwise</source>
   <translation>齿向</translation>
  </message>
  <message>
   <source>Lengthwise crown</source>
   <translation>齿向鼓形</translation>
  </message>
  <message>
   <source>Lengthwise crowning</source>
   <translation>齿向鼓形</translation>
  </message>
  <message>
   <source>Lengthwise curve</source>
   <translation>齿线</translation>
  </message>
  <message>
   <source>Less theory</source>
   <translation>减去理论值</translation>
  </message>
  <message>
   <source>Less theory, in %</source>
   <translation>减去理论值，%</translation>
  </message>
  <message>
   <source>Let the range follow the values shown</source>
   <translation>范围随显示的值变化</translation>
  </message>
  <message>
   <source>Letters of a command, or a key such as Ctrl+S</source>
   <translation>命令的字母，或如 Ctrl+S 的按键</translation>
  </message>
  <message>
   <source>Level</source>
   <translation>级别</translation>
  </message>
  <message>
   <source>Light</source>
   <translation>浅色</translation>
  </message>
  <message>
   <source>Limit [µm]</source>
   <translation>限值 [µm]</translation>
  </message>
  <message>
   <source>Limit pressure angle</source>
   <translation>极限压力角</translation>
  </message>
  <message>
   <source>Limit pressure angle factor</source>
   <translation>极限压力角系数</translation>
  </message>
  <message>
   <source>Limit radius</source>
   <translation>极限半径</translation>
  </message>
  <message>
   <source>Linear</source>
   <translation>线性</translation>
  </message>
  <message>
   <source>Lines of equal value at the marks of the colour scale</source>
   <translation>色标刻度处的等值线</translation>
  </message>
  <message>
   <source>List and change the keys of all commands</source>
   <translation>列出并更改所有命令的快捷键</translation>
  </message>
  <message>
   <source>Log</source>
   <translation>日志</translation>
  </message>
  <message>
   <source>Log scale</source>
   <translation>对数</translation>
  </message>
  <message>
   <source>Logarithmic pair</source>
   <translation>对数齿轮副</translation>
  </message>
  <message>
   <source>Logarithmic spiral</source>
   <translation>对数螺旋线</translation>
  </message>
  <message>
   <source>Longest: {length}; up is metal added</source>
   <translation>最长：{length}；向上为多余金属</translation>
  </message>
  <message>
   <source>Look for edits that a window which ended unexpectedly had not saved</source>
   <translation>查找意外结束的窗口未保存的修改</translation>
  </message>
  <message>
   <source>Lower end of the scale</source>
   <translation>色标下限</translation>
  </message>
  <message>
   <source>Lowest deviation</source>
   <translation>最低偏差</translation>
  </message>
  <message>
   <source>Lowest … highest</source>
   <translation>最小 … 最大</translation>
  </message>
  <message>
   <source>Made</source>
   <translation>生成</translation>
  </message>
  <message>
   <source>Map</source>
   <translation>云图</translation>
  </message>
  <message>
   <source>Maps and charts of</source>
   <translation>云图和图表对象</translation>
  </message>
  <message>
   <source>Maps show</source>
   <translation>云图对象</translation>
  </message>
  <message>
   <source>Margins</source>
   <translation>裕量</translation>
  </message>
  <message>
   <source>Mass</source>
   <translation>质量</translation>
  </message>
  <message>
   <source>Material</source>
   <translation>材料</translation>
  </message>
  <message>
   <source>Material that the mass is computed with</source>
   <translation>计算质量所用的材料</translation>
  </message>
  <message>
   <source>Max</source>
   <translation>最大</translation>
  </message>
  <message>
   <source>Mean</source>
   <translation>平均</translation>
  </message>
  <message>
   <source>Mean addendum</source>
   <translation>中点齿顶高</translation>
  </message>
  <message>
   <source>Mean addendum and dedendum</source>
   <translation>中点齿顶高与齿根高</translation>
  </message>
  <message>
   <source>Mean addendum factor</source>
   <translation>中点齿顶高系数</translation>
  </message>
  <message>
   <source>Mean chordal addendum</source>
   <translation>中点弦齿高</translation>
  </message>
  <message>
   <source>Mean clearance</source>
   <translation>中点顶隙</translation>
  </message>
  <message>
   <source>Mean cone distance</source>
   <translation>中锥距</translation>
  </message>
  <message>
   <source>Mean curvature</source>
   <translation>平均曲率</translation>
  </message>
  <message>
   <source>Mean dedendum</source>
   <translation>中点齿根高</translation>
  </message>
  <message>
   <source>Mean deviation without its sign</source>
   <translation>平均偏差（绝对值）</translation>
  </message>
  <message>
   <source>Mean normal chordal thickness</source>
   <translation>中点法向弦齿厚</translation>
  </message>
  <message>
   <source>Mean normal circular thickness</source>
   <translation>中点法向弧齿厚</translation>
  </message>
  <message>
   <source>Mean normal module</source>
   <translation>中点法向模数</translation>
  </message>
  <message>
   <source>Mean normal thickness</source>
   <translation>中点法向齿厚</translation>
  </message>
  <message>
   <source>Mean of the absolute deviations</source>
   <translation>偏差绝对值的平均</translation>
  </message>
  <message>
   <source>Mean pitch diameter</source>
   <translation>中点节圆直径</translation>
  </message>
  <message>
   <source>Mean radii</source>
   <translation>中点半径</translation>
  </message>
  <message>
   <source>Mean root diameter</source>
   <translation>中点根圆直径</translation>
  </message>
  <message>
   <source>Mean spiral angle</source>
   <translation>中点螺旋角</translation>
  </message>
  <message>
   <source>Mean tip diameter</source>
   <translation>中点顶圆直径</translation>
  </message>
  <message>
   <source>Mean whole depth</source>
   <translation>中点全齿高</translation>
  </message>
  <message>
   <source>Mean working depth</source>
   <translation>中点工作齿高</translation>
  </message>
  <message>
   <source>Mean, pitch cone</source>
   <translation>中点，节锥</translation>
  </message>
  <message>
   <source>Mean: at the mean point on the pitch cone. Toe: at the toe on the base cone, as the paper gives it.</source>
   <translation>中点：节锥上的中点。小端：基锥上的小端，同论文。</translation>
  </message>
  <message>
   <source>Measure</source>
   <translation>测量</translation>
  </message>
  <message>
   <source>Measured in the tangent plane; it is the arc ψ at which the involute crosses the pitch cone.</source>
   <translation>在切平面内度量；即渐开线与节锥相交处的弧 ψ。</translation>
  </message>
  <message>
   <source>Measured points</source>
   <translation>测点</translation>
  </message>
  <message>
   <source>Measured points against the theory: errors of the flanks, a map, the pitch</source>
   <translation>测点与理论对照：齿面误差、偏差图、齿距</translation>
  </message>
  <message>
   <source>Measured points against theory</source>
   <translation>测点与理论对比</translation>
  </message>
  <message>
   <source>Measured points and models</source>
   <translation>测点与模型</translation>
  </message>
  <message>
   <source>Measured points on the gear, coloured by their deviation</source>
   <translation>齿轮上的测点，按偏差着色</translation>
  </message>
  <message>
   <source>Measurement</source>
   <translation>测量</translation>
  </message>
  <message>
   <source>Member</source>
   <translation>齿轮</translation>
  </message>
  <message>
   <source>Member whose mean spiral angle is given; both have the same without an offset.</source>
   <translation>给出中点螺旋角的齿轮；无偏置时两者相同。</translation>
  </message>
  <message>
   <source>Memory of the CAD kernel</source>
   <translation>CAD 内核内存</translation>
  </message>
  <message>
   <source>Memory, graphics and recovery</source>
   <translation>内存、图形和恢复</translation>
  </message>
  <message>
   <source>Menu</source>
   <translation>菜单</translation>
  </message>
  <message>
   <source>Metal at the corners root-toe and tip-heel more than at the other two.</source>
   <translation>齿根小端和齿顶大端两角比另两角多出的金属。</translation>
  </message>
  <message>
   <source>Metal at the heel more than at the toe, over the whole face; nothing changes in the middle.</source>
   <translation>整个齿宽上大端比小端多出的金属；中部不变。</translation>
  </message>
  <message>
   <source>Metal at the tip more than at the root, over the whole depth of the flank; nothing changes in the middle.</source>
   <translation>整个齿高上齿顶比齿根多出的金属；中部不变。</translation>
  </message>
  <message>
   <source>Metal taken off a flank</source>
   <translation>齿面上去除的金属</translation>
  </message>
  <message>
   <source>Metal taken off at root and tip of the flank, rising as a parabola from the middle of its depth.</source>
   <translation>齿根与齿顶处去除的金属，自齿高中部按抛物线增加。</translation>
  </message>
  <message>
   <source>Metal taken off at the lower edge of the flank; it fades out as a cube, without a kink.</source>
   <translation>齿面下缘去除的金属；按三次曲线渐消，无折点。</translation>
  </message>
  <message>
   <source>Metal taken off at the tip; it grows from where it starts as a cube, without a kink in slope or curvature.</source>
   <translation>齿顶去除的金属；自起点按三次曲线增加，斜率与曲率连续。</translation>
  </message>
  <message>
   <source>Metal taken off at toe and heel, rising as a parabola from the middle of the face.</source>
   <translation>小端与大端去除的金属，自齿宽中部按抛物线增加。</translation>
  </message>
  <message>
   <source>Method</source>
   <translation>方法</translation>
  </message>
  <message>
   <source>Method 1 as written; Method 0 without an offset</source>
   <translation>按方法 1；无偏置时用方法 0</translation>
  </message>
  <message>
   <source>Method comparison</source>
   <translation>方法比较</translation>
  </message>
  <message>
   <source>Methods</source>
   <translation>方法</translation>
  </message>
  <message>
   <source>Micro-geometry</source>
   <translation>微观几何</translation>
  </message>
  <message>
   <source>Micro-geometry: pinion, concave</source>
   <translation>微观几何：小轮，凹面</translation>
  </message>
  <message>
   <source>Micro-geometry: pinion, convex</source>
   <translation>微观几何：小轮，凸面</translation>
  </message>
  <message>
   <source>Micro-geometry: wheel, concave</source>
   <translation>微观几何：大轮，凹面</translation>
  </message>
  <message>
   <source>Micro-geometry: wheel, convex</source>
   <translation>微观几何：大轮，凸面</translation>
  </message>
  <message>
   <source>Millimetres</source>
   <translation>毫米</translation>
  </message>
  <message>
   <source>Modified contact ratio</source>
   <translation>修正重合度</translation>
  </message>
  <message>
   <source>Motion</source>
   <translation>运动</translation>
  </message>
  <message>
   <source>Mounting distance</source>
   <translation>安装距</translation>
  </message>
  <message>
   <source>NOT VALID</source>
   <translation>无效</translation>
  </message>
  <message>
   <source>NURBS surface</source>
   <translation>NURBS 曲面</translation>
  </message>
  <message>
   <source>Name</source>
   <translation>名称</translation>
  </message>
  <message>
   <source>Names</source>
   <translation>名称</translation>
  </message>
  <message>
   <source>Names of the members and of every face</source>
   <translation>各轮及每个面的名称</translation>
  </message>
  <message>
   <source>New &amp;window</source>
   <translation>新窗口(&amp;W)</translation>
  </message>
  <message>
   <source>New key</source>
   <translation>新快捷键</translation>
  </message>
  <message>
   <source>Next</source>
   <translation>下一个</translation>
  </message>
  <message>
   <source>Next place where the words stand</source>
   <translation>下一处</translation>
  </message>
  <message>
   <source>No 3D views</source>
   <translation>无 3D 视图</translation>
  </message>
  <message>
   <source>No contact</source>
   <translation>无接触</translation>
  </message>
  <message>
   <source>No limit</source>
   <translation>不限</translation>
  </message>
  <message>
   <source>No misalignment, usual marking compound</source>
   <translation>无安装误差，常用涂料厚度</translation>
  </message>
  <message>
   <source>No parameter has these words</source>
   <translation>没有含这些词的参数</translation>
  </message>
  <message>
   <source>No picture: {why}</source>
   <translation>无图像：{why}</translation>
  </message>
  <message>
   <source>No pictures were handed in.</source>
   <translation>未提供图片。</translation>
  </message>
  <message>
   <source>No points</source>
   <translation>无测点</translation>
  </message>
  <message>
   <source>No points yet: open a file of measured points in mm, or a STEP file; apex at the origin, axis along z.</source>
   <translation>尚无测点：打开以 mm 为单位的测点文件或 STEP 文件；锥顶在原点，轴沿 z。</translation>
  </message>
  <message>
   <source>Nominal grid…</source>
   <translation>名义网格…</translation>
  </message>
  <message>
   <source>None: all four flanks are the theoretical ones.</source>
   <translation>无：四个齿面均为理论齿面。</translation>
  </message>
  <message>
   <source>Normal chordal thickness, mean</source>
   <translation>法向弦齿厚，中点</translation>
  </message>
  <message>
   <source>Normal circular thickness, mean</source>
   <translation>法向弧齿厚，中点</translation>
  </message>
  <message>
   <source>Normal pressure angle, coast flank</source>
   <translation>法向压力角，反驱动面</translation>
  </message>
  <message>
   <source>Normal pressure angle, drive flank</source>
   <translation>法向压力角，正驱动面</translation>
  </message>
  <message>
   <source>Normal pressure angle, mean point</source>
   <translation>法向压力角，中点</translation>
  </message>
  <message>
   <source>Normal to the flank, positive where metal is added; exact to second order, beyond which the foot point is iterated.</source>
   <translation>沿齿面法向，金属多余为正；二阶精确，更高阶则迭代垂足。</translation>
  </message>
  <message>
   <source>Normal to the flank: crowning along the face and over the profile, corrections of spiral and pressure angle, bias, tip and root relief. ξ runs from −1 at the toe to 1 at the heel, η from −1 at the flank's lower edge to 1 at the tip. D is the drive flank, concave on the pinion and convex on the wheel; C is the coast flank.</source>
   <translation>沿齿面法线：齿向和齿廓鼓形、螺旋角和压力角修正、扭曲、齿顶和齿根修缘。 ξ 从小端的 −1 到大端的 1， η 从齿面下边缘的 −1 到齿顶的 1。D 为正驱动面，在小轮上为凹面，在大轮上为凸面；C 为反驱动面。</translation>
  </message>
  <message>
   <source>Normal, mean point</source>
   <translation>法向，中点</translation>
  </message>
  <message>
   <source>Normal: in the normal section at the mean point, as standards give it. Transverse: as the paper gives it.</source>
   <translation>法向：中点法截面，同标准。端面：同论文。</translation>
  </message>
  <message>
   <source>Normals</source>
   <translation>法线</translation>
  </message>
  <message>
   <source>Not built yet</source>
   <translation>尚未构建</translation>
  </message>
  <message>
   <source>Not used now.</source>
   <translation>当前未使用。</translation>
  </message>
  <message>
   <source>Note</source>
   <translation>备注</translation>
  </message>
  <message>
   <source>Nothing found</source>
   <translation>未找到</translation>
  </message>
  <message>
   <source>Nothing is lost: save the design in another folder.</source>
   <translation>没有丢失：请将设计保存到其他文件夹。</translation>
  </message>
  <message>
   <source>Now: {value}</source>
   <translation>当前：{value}</translation>
  </message>
  <message>
   <source>Number of faces of the solid</source>
   <translation>实体的面数</translation>
  </message>
  <message>
   <source>Number of stripes</source>
   <translation>条纹数</translation>
  </message>
  <message>
   <source>Number of teeth</source>
   <translation>齿数</translation>
  </message>
  <message>
   <source>Number of teeth of the pinion.</source>
   <translation>小轮齿数。</translation>
  </message>
  <message>
   <source>Number of teeth of the wheel.</source>
   <translation>大轮齿数。</translation>
  </message>
  <message>
   <source>OUT OF LIMITS</source>
   <translation>超限</translation>
  </message>
  <message>
   <source>Obtuse shafts, logarithmic spiral</source>
   <translation>钝角轴，对数螺旋线</translation>
  </message>
  <message>
   <source>Of mass, from the apex</source>
   <translation>质心距锥顶</translation>
  </message>
  <message>
   <source>Of pitch, tip and root circle, with cone distance and depths of the place; the numbers are those of the heel.</source>
   <translation>节圆、顶圆和根圆，取该处的锥距和齿高；数值为大端的。</translation>
  </message>
  <message>
   <source>Of the disc between hub and rim, from the back face.</source>
   <translation>轮毂与轮缘间辐板的厚度，自背面起。</translation>
  </message>
  <message>
   <source>Of the edges between tip and ends of the teeth, turned over all teeth at toe and heel; its legs along the face cone and along the end, 0 for none.</source>
   <translation>齿顶与齿端之间的棱，在大小端绕全齿车出；两直角边沿面锥和端面，0 表示无。</translation>
  </message>
  <message>
   <source>Of the section square to the tooth at the mean point.</source>
   <translation>中点处垂直于轮齿的截面内。</translation>
  </message>
  <message>
   <source>Of the whole surface</source>
   <translation>整个表面</translation>
  </message>
  <message>
   <source>Offset</source>
   <translation>偏置距</translation>
  </message>
  <message>
   <source>Offset angle, axial plane</source>
   <translation>偏置角，轴平面</translation>
  </message>
  <message>
   <source>Offset angle, face plane</source>
   <translation>偏置角，面平面</translation>
  </message>
  <message>
   <source>Offset angle, pitch plane</source>
   <translation>偏置角，节平面</translation>
  </message>
  <message>
   <source>Offset angle, root plane</source>
   <translation>偏置角，根平面</translation>
  </message>
  <message>
   <source>Offset axes</source>
   <translation>偏置轴</translation>
  </message>
  <message>
   <source>Offset in the pitch plane</source>
   <translation>节平面内偏置</translation>
  </message>
  <message>
   <source>On by a twelfth of a tooth</source>
   <translation>前进十二分之一齿</translation>
  </message>
  <message>
   <source>On the base cone, as the paper gives it; β_i is the spiral angle on the pitch cone there.</source>
   <translation>在基锥上，如论文所给； β_i 为该处节锥上的螺旋角。</translation>
  </message>
  <message>
   <source>One camera for all</source>
   <translation>共用相机</translation>
  </message>
  <message>
   <source>One closed shell</source>
   <translation>一个封闭壳</translation>
  </message>
  <message>
   <source>One flank of the three methods, coloured by its deviation from the exact flank.</source>
   <translation>三种方法的一侧齿面，按其相对精确齿面的偏差着色。</translation>
  </message>
  <message>
   <source>One of: {choices}.</source>
   <translation>可选：{choices}。</translation>
  </message>
  <message>
   <source>One tooth</source>
   <translation>单齿</translation>
  </message>
  <message>
   <source>One tooth was measured: there is no pitch to compare</source>
   <translation>仅测了一个齿：无齿距可比较</translation>
  </message>
  <message>
   <source>One unit of the file is a metre, as glTF asks; mm is for programs that do not scale</source>
   <translation>文件单位为米（glTF 要求）；mm 供不缩放的程序使用</translation>
  </message>
  <message>
   <source>Only one window can save it. Read-only, Save asks for another name; a copy starts as a new design.</source>
   <translation>只有一个窗口能保存。只读打开时，保存会要求新名称；副本作为新设计开始。</translation>
  </message>
  <message>
   <source>Only the Archimedean spiral can take its angle at the toe.</source>
   <translation>只有阿基米德螺旋线可在小端给定角度。</translation>
  </message>
  <message>
   <source>Only the rolled arc is divided by sin δ_b: the second term is an angle about the axis already.</source>
   <translation>只有滚动弧除以 sin δ_b：第二项已是绕轴的角度。</translation>
  </message>
  <message>
   <source>Opacity</source>
   <translation>不透明度</translation>
  </message>
  <message>
   <source>Open &amp;read-only</source>
   <translation>只读打开(&amp;R)</translation>
  </message>
  <message>
   <source>Open &amp;recent</source>
   <translation>最近打开(&amp;R)</translation>
  </message>
  <message>
   <source>Open &amp;recovered</source>
   <translation>打开恢复版本(&amp;R)</translation>
  </message>
  <message>
   <source>Open &amp;saved</source>
   <translation>打开保存版本(&amp;S)</translation>
  </message>
  <message>
   <source>Open a &amp;copy</source>
   <translation>打开副本(&amp;C)</translation>
  </message>
  <message>
   <source>Open a design file (.gear.toml)</source>
   <translation>打开设计文件 (.gear.toml)</translation>
  </message>
  <message>
   <source>Open another window, with a CAD process of its own</source>
   <translation>打开另一个窗口，带独立的 CAD 进程</translation>
  </message>
  <message>
   <source>Open design</source>
   <translation>打开设计</translation>
  </message>
  <message>
   <source>Open measured points on the page Measurement first</source>
   <translation>请先在“测量”页打开测点</translation>
  </message>
  <message>
   <source>Open measured points or a STEP file</source>
   <translation>打开测点或 STEP 文件</translation>
  </message>
  <message>
   <source>Open points or STEP…</source>
   <translation>打开测点或 STEP…</translation>
  </message>
  <message>
   <source>Open the file as it was saved; the recovered edits stay</source>
   <translation>按保存的状态打开文件；恢复的修改保留</translation>
  </message>
  <message>
   <source>OpenGL {needed} is needed, and {renderer} offers {version}.</source>
   <translation>需要 OpenGL {needed}，而 {renderer} 提供 {version}。</translation>
  </message>
  <message>
   <source>Optimised</source>
   <translation>优化</translation>
  </message>
  <message>
   <source>Other</source>
   <translation>另一个</translation>
  </message>
  <message>
   <source>Other design</source>
   <translation>另一设计</translation>
  </message>
  <message>
   <source>Out of date: the design has changed</source>
   <translation>已过时：设计已更改</translation>
  </message>
  <message>
   <source>Out of date: the design was changed after these pages were made. Update the preview.</source>
   <translation>已过时：生成这些页后设计已更改。请更新预览。</translation>
  </message>
  <message>
   <source>Outer addendum</source>
   <translation>大端齿顶高</translation>
  </message>
  <message>
   <source>Outer clearance</source>
   <translation>大端顶隙</translation>
  </message>
  <message>
   <source>Outer cone distance</source>
   <translation>外锥距</translation>
  </message>
  <message>
   <source>Outer dedendum</source>
   <translation>大端齿根高</translation>
  </message>
  <message>
   <source>Outer diameter of the hub, on the side of the apex.</source>
   <translation>轮毂外径，锥顶一侧。</translation>
  </message>
  <message>
   <source>Outer module</source>
   <translation>大端模数</translation>
  </message>
  <message>
   <source>Outer module: the factors of the tooth, over the outer module at the heel. ISO 23509: factors of the mean normal module at the mean point, with a taper.</source>
   <translation>大端模数：以大端模数计的齿系数。ISO 23509：以中点法向模数计的系数，带收缩方式。</translation>
  </message>
  <message>
   <source>Outer pitch diameter</source>
   <translation>大端节圆直径</translation>
  </message>
  <message>
   <source>Outer root diameter</source>
   <translation>大端根圆直径</translation>
  </message>
  <message>
   <source>Outer spiral angle</source>
   <translation>大端螺旋角</translation>
  </message>
  <message>
   <source>Outer tip diameter</source>
   <translation>大端顶圆直径</translation>
  </message>
  <message>
   <source>Outer transverse module</source>
   <translation>大端端面模数</translation>
  </message>
  <message>
   <source>Outer transverse module of the wheel</source>
   <translation>大轮大端端面模数</translation>
  </message>
  <message>
   <source>Outer transverse module: heel pitch diameter over teeth.</source>
   <translation>大端端面模数：大端节圆直径除以齿数。</translation>
  </message>
  <message>
   <source>Outer whole depth</source>
   <translation>大端全齿高</translation>
  </message>
  <message>
   <source>Overlap ratio</source>
   <translation>轴向重合度</translation>
  </message>
  <message>
   <source>Own base cone</source>
   <translation>自有基锥</translation>
  </message>
  <message>
   <source>P  pinion axial</source>
   <translation>P  小轮轴向</translation>
  </message>
  <message>
   <source>PDF files (*.pdf)</source>
   <translation>PDF 文件 (*.pdf)</translation>
  </message>
  <message>
   <source>Page</source>
   <translation>页</translation>
  </message>
  <message>
   <source>Page {number} of {count}</source>
   <translation>第 {number} 页，共 {count} 页</translation>
  </message>
  <message>
   <source>Pages of the preferences</source>
   <translation>首选项各页</translation>
  </message>
  <message>
   <source>Pair</source>
   <translation>齿轮副</translation>
  </message>
  <message>
   <source>Pair in mesh</source>
   <translation>啮合齿轮副</translation>
  </message>
  <message>
   <source>Pair in mesh, on by one tooth</source>
   <translation>齿轮副啮合，转过一齿</translation>
  </message>
  <message>
   <source>Panels that share a place</source>
   <translation>共用同一位置的面板</translation>
  </message>
  <message>
   <source>Paper</source>
   <translation>论文</translation>
  </message>
  <message>
   <source>Parallel</source>
   <translation>平行</translation>
  </message>
  <message>
   <source>Parallel shows true proportions</source>
   <translation>平行投影显示真实比例</translation>
  </message>
  <message>
   <source>Parameter</source>
   <translation>参数</translation>
  </message>
  <message>
   <source>Parameters</source>
   <translation>参数</translation>
  </message>
  <message>
   <source>Parameters and derived values beside those of another design</source>
   <translation>参数和推导值与另一设计并列</translation>
  </message>
  <message>
   <source>Parameters and derived values of both designs</source>
   <translation>两个设计的参数和推导值</translation>
  </message>
  <message>
   <source>Parameters that differ</source>
   <translation>不同的参数</translation>
  </message>
  <message>
   <source>Parameters that the equation uses</source>
   <translation>公式所用的参数</translation>
  </message>
  <message>
   <source>Parameters: {group}</source>
   <translation>参数：{group}</translation>
  </message>
  <message>
   <source>Part</source>
   <translation>部分</translation>
  </message>
  <message>
   <source>Paste</source>
   <translation>粘贴</translation>
  </message>
  <message>
   <source>Pattern</source>
   <translation>接触斑点</translation>
  </message>
  <message>
   <source>Pattern [%]</source>
   <translation>斑点 [%]</translation>
  </message>
  <message>
   <source>Peak to peak</source>
   <translation>峰峰值</translation>
  </message>
  <message>
   <source>Perspective</source>
   <translation>透视</translation>
  </message>
  <message>
   <source>Pi&amp;cture…</source>
   <translation>图片(&amp;C)…</translation>
  </message>
  <message>
   <source>Picture</source>
   <translation>图片</translation>
  </message>
  <message>
   <source>Picture (*.png);;Drawing (*.svg);;Table (*.csv)</source>
   <translation>图片 (*.png);;矢量图 (*.svg);;表格 (*.csv)</translation>
  </message>
  <message>
   <source>Picture of</source>
   <translation>图片内容</translation>
  </message>
  <message>
   <source>Pinion</source>
   <translation>小轮</translation>
  </message>
  <message>
   <source>Pinion along its axis, positive away from the crossing point</source>
   <translation>小轮沿其轴线，离开轴线交点为正</translation>
  </message>
  <message>
   <source>Pinion axis beside the wheel's, positive as a positive hypoid offset</source>
   <translation>小轮轴相对大轮轴的偏移，符号同准双曲面偏置</translation>
  </message>
  <message>
   <source>Pinion blank</source>
   <translation>小轮轮坯</translation>
  </message>
  <message>
   <source>Pinion teeth</source>
   <translation>小轮齿数</translation>
  </message>
  <message>
   <source>Pinion {pinion:.1f}° · wheel {wheel:.1f}°</source>
   <translation>小轮 {pinion:.1f}° · 大轮 {wheel:.1f}°</translation>
  </message>
  <message>
   <source>Pitch</source>
   <translation>齿距</translation>
  </message>
  <message>
   <source>Pitch angle</source>
   <translation>节锥角</translation>
  </message>
  <message>
   <source>Pitch apex</source>
   <translation>节锥顶</translation>
  </message>
  <message>
   <source>Pitch apex beyond crossing point</source>
   <translation>节锥顶至交错点</translation>
  </message>
  <message>
   <source>Pitch cone</source>
   <translation>节锥</translation>
  </message>
  <message>
   <source>Pitch cone angle</source>
   <translation>节锥角</translation>
  </message>
  <message>
   <source>Pitch cones in contact</source>
   <translation>相切的节锥</translation>
  </message>
  <message>
   <source>Pitch diameter, heel</source>
   <translation>节圆直径，大端</translation>
  </message>
  <message>
   <source>Pitch error</source>
   <translation>齿距偏差</translation>
  </message>
  <message>
   <source>Pitch to base element</source>
   <translation>节锥至基锥母线</translation>
  </message>
  <message>
   <source>Pitch to base element, in the tangent plane</source>
   <translation>节锥至基锥母线，切平面内</translation>
  </message>
  <message>
   <source>Pitch, single</source>
   <translation>单个齿距</translation>
  </message>
  <message>
   <source>Pitch, total</source>
   <translation>齿距累积总</translation>
  </message>
  <message>
   <source>Pixels of the picture for one on the screen</source>
   <translation>屏幕每像素对应的图片像素</translation>
  </message>
  <message>
   <source>Place along the face</source>
   <translation>沿齿宽位置</translation>
  </message>
  <message>
   <source>Place along the profile</source>
   <translation>沿齿廓位置</translation>
  </message>
  <message>
   <source>Place of the section</source>
   <translation>剖切位置</translation>
  </message>
  <message>
   <source>Place on a flank</source>
   <translation>齿面上的位置</translation>
  </message>
  <message>
   <source>Places along the generating line</source>
   <translation>沿母线的位置</translation>
  </message>
  <message>
   <source>Play</source>
   <translation>播放</translation>
  </message>
  <message>
   <source>Point</source>
   <translation>点</translation>
  </message>
  <message>
   <source>Point cloud</source>
   <translation>点云</translation>
  </message>
  <message>
   <source>Point cloud degree</source>
   <translation>点云阶次</translation>
  </message>
  <message>
   <source>Point in spherical coordinates</source>
   <translation>球坐标中的点</translation>
  </message>
  <message>
   <source>Point series</source>
   <translation>点列</translation>
  </message>
  <message>
   <source>Points</source>
   <translation>点</translation>
  </message>
  <message>
   <source>Points and surfaces</source>
   <translation>点与曲面</translation>
  </message>
  <message>
   <source>Points left out beside the flanks</source>
   <translation>齿面之外舍去的点</translation>
  </message>
  <message>
   <source>Points of the exact flank on U and V lines</source>
   <translation>精确齿面 U、V 线上的点</translation>
  </message>
  <message>
   <source>Points on the flanks</source>
   <translation>齿面上的点</translation>
  </message>
  <message>
   <source>Points, U and V lines</source>
   <translation>点、U 线和 V 线</translation>
  </message>
  <message>
   <source>Poles</source>
   <translation>控制点</translation>
  </message>
  <message>
   <source>Positions, sections, or points along each side of the grid</source>
   <translation>网格每边的位置、截面或点数</translation>
  </message>
  <message>
   <source>Preferences</source>
   <translation>首选项</translation>
  </message>
  <message>
   <source>Preparing 3D view…</source>
   <translation>正在准备 3D 视图…</translation>
  </message>
  <message>
   <source>Preparing the analysis…</source>
   <translation>正在准备分析…</translation>
  </message>
  <message>
   <source>Press the new keys here</source>
   <translation>在此按下新快捷键</translation>
  </message>
  <message>
   <source>Pressure angle</source>
   <translation>压力角</translation>
  </message>
  <message>
   <source>Pressure angle correction</source>
   <translation>压力角修正</translation>
  </message>
  <message>
   <source>Pressure angle is</source>
   <translation>压力角类型</translation>
  </message>
  <message>
   <source>Pressure angle of both flanks.</source>
   <translation>两侧齿面的压力角。</translation>
  </message>
  <message>
   <source>Pressure angle, normal</source>
   <translation>压力角，法向</translation>
  </message>
  <message>
   <source>Pressure angle, transv.</source>
   <translation>压力角，端面</translation>
  </message>
  <message>
   <source>Pressure angles and base cones of both flanks</source>
   <translation>两侧齿面的压力角与基锥</translation>
  </message>
  <message>
   <source>Preview of the report</source>
   <translation>报告预览</translation>
  </message>
  <message>
   <source>Principal 1 (largest)</source>
   <translation>主曲率 1（最大）</translation>
  </message>
  <message>
   <source>Principal 2 (smallest)</source>
   <translation>主曲率 2（最小）</translation>
  </message>
  <message>
   <source>Printed 0.963 rad; used 0.286 rad, which gives back β₀ at the toe (17/40 teeth, m = 4 mm, wheel).</source>
   <translation>印刷值 0.963 rad；采用 0.286 rad，可还原小端 β₀（17/40 齿，m = 4 mm，大轮）。</translation>
  </message>
  <message>
   <source>Printed 21.1°; used 59.863°, which equals arcsin(sin δ cos α) (17/40 teeth, m = 4 mm, transverse 20°, wheel).</source>
   <translation>印刷值 21.1°；采用 59.863°，等于 arcsin(sin δ cos α)（17/40 齿，m = 4 mm，端面 20°，大轮）。</translation>
  </message>
  <message>
   <source>Profile at the toe</source>
   <translation>小端齿廓</translation>
  </message>
  <message>
   <source>Profile crown</source>
   <translation>齿廓鼓形</translation>
  </message>
  <message>
   <source>Profile crowning</source>
   <translation>齿廓鼓形</translation>
  </message>
  <message>
   <source>Profile shift</source>
   <translation>变位</translation>
  </message>
  <message>
   <source>Profile shift coefficient</source>
   <translation>变位系数</translation>
  </message>
  <message>
   <source>Profile shift factor</source>
   <translation>变位系数</translation>
  </message>
  <message>
   <source>Profile shift factor of the pinion; the wheel takes the negative.</source>
   <translation>小轮变位系数；大轮取其负值。</translation>
  </message>
  <message>
   <source>Profile sweep</source>
   <translation>齿廓扫掠</translation>
  </message>
  <message>
   <source>Progress of the measurement</source>
   <translation>测量进度</translation>
  </message>
  <message>
   <source>Progress of the study</source>
   <translation>研究进度</translation>
  </message>
  <message>
   <source>Projection</source>
   <translation>投影</translation>
  </message>
  <message>
   <source>Properties</source>
   <translation>属性</translation>
  </message>
  <message>
   <source>Properties of the solids</source>
   <translation>实体属性</translation>
  </message>
  <message>
   <source>Published</source>
   <translation>论文</translation>
  </message>
  <message>
   <source>Published values</source>
   <translation>已发表的值</translation>
  </message>
  <message>
   <source>Published values and those computed</source>
   <translation>已发表值与计算值</translation>
  </message>
  <message>
   <source>Purple – green</source>
   <translation>紫 – 绿</translation>
  </message>
  <message>
   <source>Put every panel back in its place</source>
   <translation>所有面板归位</translation>
  </message>
  <message>
   <source>Put it in place of what is open; Undo takes that back. No file is changed.</source>
   <translation>替换当前设计；可用撤销恢复。不改动任何文件。</translation>
  </message>
  <message>
   <source>Put the cursor into a parameter first</source>
   <translation>请先将光标置于参数中</translation>
  </message>
  <message>
   <source>Quantity</source>
   <translation>量</translation>
  </message>
  <message>
   <source>RMS</source>
   <translation>均方根</translation>
  </message>
  <message>
   <source>RMS deviation</source>
   <translation>均方根偏差</translation>
  </message>
  <message>
   <source>R_e from the pitch apex</source>
   <translation>R_e，自节锥顶起</translation>
  </message>
  <message>
   <source>R_f as asked, or of the full-round root</source>
   <translation>R_f 按要求，或为全圆齿根的</translation>
  </message>
  <message>
   <source>R_i from the pitch apex</source>
   <translation>R_i，自节锥顶起</translation>
  </message>
  <message>
   <source>R_m from the pitch apex</source>
   <translation>R_m，自节锥顶起</translation>
  </message>
  <message>
   <source>Radial</source>
   <translation>径向</translation>
  </message>
  <message>
   <source>Radius of the back plane of the base cone.</source>
   <translation>基锥底面半径。</translation>
  </message>
  <message>
   <source>Radius of the cutter whose arc the tooth follows.</source>
   <translation>刀盘半径，齿沿其圆弧。</translation>
  </message>
  <message>
   <source>Radius of the tangent circular plane, which is the heel sphere's.</source>
   <translation>相切圆平面的半径，即大端球面半径。</translation>
  </message>
  <message>
   <source>Range: {limits}</source>
   <translation>范围：{limits}</translation>
  </message>
  <message>
   <source>Re&amp;start CAD kernel</source>
   <translation>重启 CAD 内核(&amp;S)</translation>
  </message>
  <message>
   <source>Reaches {tolerance} µm with</source>
   <translation>达到 {tolerance} µm 所需</translation>
  </message>
  <message>
   <source>Read back</source>
   <translation>回读结果</translation>
  </message>
  <message>
   <source>Reading {file}…</source>
   <translation>正在读取 {file}…</translation>
  </message>
  <message>
   <source>Rebuild when the design changes</source>
   <translation>设计更改时重建</translation>
  </message>
  <message>
   <source>Recent design {number}</source>
   <translation>最近的设计 {number}</translation>
  </message>
  <message>
   <source>Reco&amp;ver unsaved work…</source>
   <translation>恢复未保存的工作(&amp;V)…</translation>
  </message>
  <message>
   <source>Recover unsaved edits</source>
   <translation>恢复未保存的修改</translation>
  </message>
  <message>
   <source>Recover unsaved work</source>
   <translation>恢复未保存的工作</translation>
  </message>
  <message>
   <source>Recovered</source>
   <translation>恢复的</translation>
  </message>
  <message>
   <source>Recovered version</source>
   <translation>恢复版本</translation>
  </message>
  <message>
   <source>Refined until the expected deviation is below the tolerance</source>
   <translation>细化直到预期偏差低于公差</translation>
  </message>
  <message>
   <source>Reflections of straight lamps in the CAD flanks</source>
   <translation>直线灯在 CAD 齿面上的反射</translation>
  </message>
  <message>
   <source>Remove &amp;missing ones</source>
   <translation>移除缺失项(&amp;M)</translation>
  </message>
  <message>
   <source>Report</source>
   <translation>报告</translation>
  </message>
  <message>
   <source>Reset</source>
   <translation>重置</translation>
  </message>
  <message>
   <source>Reset &amp;field</source>
   <translation>重置字段(&amp;F)</translation>
  </message>
  <message>
   <source>Reset a&amp;ll parameters</source>
   <translation>重置所有参数(&amp;L)</translation>
  </message>
  <message>
   <source>Reset all keys</source>
   <translation>重置所有快捷键</translation>
  </message>
  <message>
   <source>Reset all parameters</source>
   <translation>重置所有参数</translation>
  </message>
  <message>
   <source>Reset group {group}</source>
   <translation>重置组{group}</translation>
  </message>
  <message>
   <source>Reset settings</source>
   <translation>重置设置</translation>
  </message>
  <message>
   <source>Reset this group</source>
   <translation>重置此组</translation>
  </message>
  <message>
   <source>Reset to &amp;sample</source>
   <translation>重置为示例(&amp;S)</translation>
  </message>
  <message>
   <source>Reset to {preset}</source>
   <translation>重置为{preset}</translation>
  </message>
  <message>
   <source>Reset to {value}</source>
   <translation>重置为 {value}</translation>
  </message>
  <message>
   <source>Reset {field}</source>
   <translation>重置{field}</translation>
  </message>
  <message>
   <source>Restore defaults</source>
   <translation>恢复默认值</translation>
  </message>
  <message>
   <source>Return goes to the next place</source>
   <translation>回车跳到下一处</translation>
  </message>
  <message>
   <source>Right</source>
   <translation>右视</translation>
  </message>
  <message>
   <source>Right hand</source>
   <translation>右旋</translation>
  </message>
  <message>
   <source>Rms</source>
   <translation>均方根</translation>
  </message>
  <message>
   <source>Roll angle from root to tip</source>
   <translation>齿根到齿顶的滚动角</translation>
  </message>
  <message>
   <source>Roll of the tangent plane</source>
   <translation>切平面滚动</translation>
  </message>
  <message>
   <source>Roll of the tangent plane: {degrees:.1f}°</source>
   <translation>切平面滚动：{degrees:.1f}°</translation>
  </message>
  <message>
   <source>Roll the plane and let the line sweep out the flank</source>
   <translation>滚动平面，由直线扫出齿面</translation>
  </message>
  <message>
   <source>Rolling construction at δ_k = 68°: azimuth 0.0413879 rad, as the used form; the printed form gives −0.0838 rad (17/40 teeth, transverse 20°, wheel).</source>
   <translation>δ_k = 68° 处的滚动构造：方位角 0.0413879 rad，与采用形式一致；印刷形式给出 −0.0838 rad（17/40 齿，端面 20°，大轮）。</translation>
  </message>
  <message>
   <source>Rolling of the tangent plane</source>
   <translation>切平面的滚动</translation>
  </message>
  <message>
   <source>Root angle</source>
   <translation>根锥角</translation>
  </message>
  <message>
   <source>Root apex beyond crossing point</source>
   <translation>根锥顶至轴线交点</translation>
  </message>
  <message>
   <source>Root of the mean square</source>
   <translation>均方根</translation>
  </message>
  <message>
   <source>Root of the mean square deviation</source>
   <translation>偏差的均方根</translation>
  </message>
  <message>
   <source>Root relief</source>
   <translation>齿根修缘</translation>
  </message>
  <message>
   <source>Root relief ends at</source>
   <translation>齿根修缘终点</translation>
  </message>
  <message>
   <source>Root – tip</source>
   <translation>齿根 – 齿顶</translation>
  </message>
  <message>
   <source>Rotating line</source>
   <translation>滚动直线</translation>
  </message>
  <message>
   <source>Run</source>
   <translation>运行</translation>
  </message>
  <message>
   <source>Run the study: each method is built with growing effort</source>
   <translation>运行研究：以递增计算量构建各方法</translation>
  </message>
  <message>
   <source>S&amp;kip</source>
   <translation>跳过(&amp;K)</translation>
  </message>
  <message>
   <source>STEP schema</source>
   <translation>STEP 模式</translation>
  </message>
  <message>
   <source>STEP unit</source>
   <translation>STEP 单位</translation>
  </message>
  <message>
   <source>STL as</source>
   <translation>STL 格式</translation>
  </message>
  <message>
   <source>Samples, export and the report are under File; the guide, the equations and this tour under Help.</source>
   <translation>示例、导出和报告在“文件”下；指南、公式和本导览在“帮助”下。</translation>
  </message>
  <message>
   <source>Save &amp;as…</source>
   <translation>另存为(&amp;A)…</translation>
  </message>
  <message>
   <source>Save a turntable, the pair in mesh or the rolling plane as MP4 or GIF</source>
   <translation>将转台、啮合或滚动平面存为 MP4 或 GIF</translation>
  </message>
  <message>
   <source>Save as .mp4 or .gif</source>
   <translation>存为 .mp4 或 .gif</translation>
  </message>
  <message>
   <source>Save as .png or .jpg</source>
   <translation>存为 .png 或 .jpg</translation>
  </message>
  <message>
   <source>Save as PNG, SVG or CSV…</source>
   <translation>存为 PNG、SVG 或 CSV…</translation>
  </message>
  <message>
   <source>Save chart</source>
   <translation>保存图表</translation>
  </message>
  <message>
   <source>Save data sheet</source>
   <translation>保存数据表</translation>
  </message>
  <message>
   <source>Save design</source>
   <translation>保存设计</translation>
  </message>
  <message>
   <source>Save film</source>
   <translation>保存影片</translation>
  </message>
  <message>
   <source>Save nominal grid</source>
   <translation>保存名义网格</translation>
  </message>
  <message>
   <source>Save or copy a picture of the views or the window</source>
   <translation>保存或复制视图或窗口的图片</translation>
  </message>
  <message>
   <source>Save picture</source>
   <translation>保存图片</translation>
  </message>
  <message>
   <source>Save the changes to “{name}”?</source>
   <translation>保存对“{name}”的修改？</translation>
  </message>
  <message>
   <source>Save the design</source>
   <translation>保存设计</translation>
  </message>
  <message>
   <source>Save the design under another name</source>
   <translation>以其他名称保存设计</translation>
  </message>
  <message>
   <source>Save the report</source>
   <translation>保存报告</translation>
  </message>
  <message>
   <source>Save the sheet</source>
   <translation>保存数据表</translation>
  </message>
  <message>
   <source>Saved</source>
   <translation>已保存</translation>
  </message>
  <message>
   <source>Saved the chart as {written}</source>
   <translation>图表已存为 {written}</translation>
  </message>
  <message>
   <source>Saved the data sheet as {path}</source>
   <translation>数据表已存为 {path}</translation>
  </message>
  <message>
   <source>Saved the film as {path}</source>
   <translation>影片已存为 {path}</translation>
  </message>
  <message>
   <source>Saved the last good design; {count} field(s) with problems are not in {name}</source>
   <translation>已保存最后的有效设计；{count} 个有问题的字段未写入 {name}</translation>
  </message>
  <message>
   <source>Saved the nominal grid of the {member} as {path}</source>
   <translation>{member}名义网格已存为 {path}</translation>
  </message>
  <message>
   <source>Saved the picture as {path}</source>
   <translation>图片已存为 {path}</translation>
  </message>
  <message>
   <source>Saved version</source>
   <translation>保存版本</translation>
  </message>
  <message>
   <source>Saved {path}</source>
   <translation>已保存 {path}</translation>
  </message>
  <message>
   <source>Saved, but no backup could be kept: {reason}</source>
   <translation>已保存，但无法备份：{reason}</translation>
  </message>
  <message>
   <source>Scale</source>
   <translation>比例</translation>
  </message>
  <message>
   <source>Scale bar</source>
   <translation>比例尺</translation>
  </message>
  <message>
   <source>Scale of the combs</source>
   <translation>梳齿比例</translation>
  </message>
  <message>
   <source>Scale of the deviations: Auto is logarithmic where the curves differ by orders</source>
   <translation>偏差刻度：自动时，若曲线相差数量级则取对数</translation>
  </message>
  <message>
   <source>Search the parameters by title, symbol or description</source>
   <translation>按标题、符号或说明搜索参数</translation>
  </message>
  <message>
   <source>Seconds</source>
   <translation>秒</translation>
  </message>
  <message>
   <source>Section</source>
   <translation>剖切</translation>
  </message>
  <message>
   <source>Section of the {member}'s blank</source>
   <translation>{member}轮坯截面</translation>
  </message>
  <message>
   <source>Sections</source>
   <translation>截面</translation>
  </message>
  <message>
   <source>Select all</source>
   <translation>全选</translation>
  </message>
  <message>
   <source>Separate the arguments by semicolons, as in max(1,5; 2)</source>
   <translation>请用分号分隔参数，例如 max(1,5; 2)</translation>
  </message>
  <message>
   <source>Series of points</source>
   <translation>点列</translation>
  </message>
  <message>
   <source>Set of layers</source>
   <translation>图层组合</translation>
  </message>
  <message>
   <source>Settings</source>
   <translation>参数</translation>
  </message>
  <message>
   <source>Shaft angle</source>
   <translation>轴交角</translation>
  </message>
  <message>
   <source>Shaft angle beyond its nominal value</source>
   <translation>轴交角相对名义值的增量</translation>
  </message>
  <message>
   <source>Shank diameter</source>
   <translation>轴径</translation>
  </message>
  <message>
   <source>Shank length</source>
   <translation>轴长</translation>
  </message>
  <message>
   <source>Share of the flank's depth, from 0 at its lower edge to 1 at the tip; no effect without root relief.</source>
   <translation>齿面高度比例，下缘 0，齿顶 1；无齿根修缘时不起作用。</translation>
  </message>
  <message>
   <source>Share of the flank's depth, from 0 at its lower edge to 1 at the tip; no effect without tip relief.</source>
   <translation>齿面高度比例，下缘 0，齿顶 1；无齿顶修缘时不起作用。</translation>
  </message>
  <message>
   <source>Share of the limit pressure angle that the drive flank gains and the coast flank loses; no effect without an offset.</source>
   <translation>极限压力角中正驱动面增加、反驱动面减少的比例；无偏置时不起作用。</translation>
  </message>
  <message>
   <source>Share of the points</source>
   <translation>点的比例</translation>
  </message>
  <message>
   <source>Shared between both members; without a factor of its own c_ham is 0.21 + 0.29/u₉₀², the standard's proposal.</source>
   <translation>由两轮分配；未给定系数时 c_ham 为 0.21 + 0.29/u₉₀² ，即标准的建议值。</translation>
  </message>
  <message>
   <source>Shift</source>
   <translation>移动</translation>
  </message>
  <message>
   <source>Shifted by</source>
   <translation>移动量</translation>
  </message>
  <message>
   <source>Shifted by the best fit</source>
   <translation>最佳拟合的移动量</translation>
  </message>
  <message>
   <source>Show</source>
   <translation>显示</translation>
  </message>
  <message>
   <source>Show equation</source>
   <translation>显示公式</translation>
  </message>
  <message>
   <source>Show everything as in a new window; layers keep their colours</source>
   <translation>恢复为新窗口的显示；图层颜色保留</translation>
  </message>
  <message>
   <source>Show the equation of this row with its numbers (Enter)</source>
   <translation>显示此行的公式及数值（回车）</translation>
  </message>
  <message>
   <source>Show the pinion and build its flanks</source>
   <translation>显示小轮并构建其齿面</translation>
  </message>
  <message>
   <source>Show the wheel and build its flanks</source>
   <translation>显示大轮并构建其齿面</translation>
  </message>
  <message>
   <source>Show what else is known</source>
   <translation>显示其他已知信息</translation>
  </message>
  <message>
   <source>Show: {words}</source>
   <translation>显示：{words}</translation>
  </message>
  <message>
   <source>Shown and typed in this unit; files stay in mm</source>
   <translation>以此单位显示和键入；文件仍为 mm</translation>
  </message>
  <message>
   <source>Side of the teeth</source>
   <translation>齿侧</translation>
  </message>
  <message>
   <source>Signed extremes: most metal missing, most metal added</source>
   <translation>带符号的极值：金属最少、最多</translation>
  </message>
  <message>
   <source>Signed normal deviation of the solid's flanks from theory</source>
   <translation>实体齿面与理论的带符号法向偏差</translation>
  </message>
  <message>
   <source>Single and cumulative pitch errors</source>
   <translation>单个与累积齿距偏差</translation>
  </message>
  <message>
   <source>Size</source>
   <translation>尺寸</translation>
  </message>
  <message>
   <source>Size of the film in pixels</source>
   <translation>影片尺寸（像素）</translation>
  </message>
  <message>
   <source>Sizes of the teeth</source>
   <translation>轮齿尺寸</translation>
  </message>
  <message>
   <source>Smallest principal</source>
   <translation>最小主</translation>
  </message>
  <message>
   <source>Smooth</source>
   <translation>平滑</translation>
  </message>
  <message>
   <source>Snap to corners and middles of edges</source>
   <translation>捕捉角点和边的中点</translation>
  </message>
  <message>
   <source>Software, without the graphics card</source>
   <translation>软件绘制，不用显卡</translation>
  </message>
  <message>
   <source>Solid</source>
   <translation>实体</translation>
  </message>
  <message>
   <source>Solids know which faces meet; trimmed surfaces are for programs that know no solids</source>
   <translation>实体知道各面如何相接；裁剪曲面供不支持实体的程序使用</translation>
  </message>
  <message>
   <source>Some of the paper's are those of bevel pairs with depths from the module: numbers are put in where an equation holds for this pair.</source>
   <translation>论文中的部分公式适用于齿高由模数确定的锥齿轮副：仅在公式对本齿轮副成立处代入数值。</translation>
  </message>
  <message>
   <source>Something unexpected went wrong. The window goes on, and the design is still there: save it under a new name to be safe. The report below helps to mend the fault; it is also in {path}.</source>
   <translation>发生意外错误。窗口继续运行，设计仍在：为安全起见请以新名称保存。下面的报告有助于修复，也保存在 {path}。</translation>
  </message>
  <message>
   <source>Source</source>
   <translation>来源</translation>
  </message>
  <message>
   <source>Speed</source>
   <translation>速度</translation>
  </message>
  <message>
   <source>Speed; at 1× one tooth passes each second</source>
   <translation>速度；1× 时每秒一齿</translation>
  </message>
  <message>
   <source>Spheres</source>
   <translation>球面</translation>
  </message>
  <message>
   <source>Spherical involute</source>
   <translation>球面渐开线</translation>
  </message>
  <message>
   <source>Spherical involute, 14/39, transverse pressure angle 20°</source>
   <translation>球面渐开线，14/39，端面压力角 20°</translation>
  </message>
  <message>
   <source>Spiral angle</source>
   <translation>螺旋角</translation>
  </message>
  <message>
   <source>Spiral angle at</source>
   <translation>螺旋角位置</translation>
  </message>
  <message>
   <source>Spiral angle at the cone distance R' of a tooth trace that is an arc of the cutter's radius r₀.</source>
   <translation>齿线为刀盘半径 r₀ 圆弧时，锥距 R' 处的螺旋角。</translation>
  </message>
  <message>
   <source>Spiral angle at the toe</source>
   <translation>小端螺旋角</translation>
  </message>
  <message>
   <source>Spiral angle correction</source>
   <translation>螺旋角修正</translation>
  </message>
  <message>
   <source>Spiral angle of</source>
   <translation>螺旋角属于</translation>
  </message>
  <message>
   <source>Spiral angle, as an angle</source>
   <translation>螺旋角（以角度计）</translation>
  </message>
  <message>
   <source>Spiral angle, heel</source>
   <translation>螺旋角，大端</translation>
  </message>
  <message>
   <source>Spiral angle, mean</source>
   <translation>螺旋角，中点</translation>
  </message>
  <message>
   <source>Spiral angle, toe</source>
   <translation>螺旋角，小端</translation>
  </message>
  <message>
   <source>Spiral angle; 0 gives straight teeth, or zerol teeth with the circular arc.</source>
   <translation>螺旋角；0 为直齿，圆弧时为零度齿。</translation>
  </message>
  <message>
   <source>Spiral angles of both members</source>
   <translation>两轮的螺旋角</translation>
  </message>
  <message>
   <source>Spiral bevel gear report</source>
   <translation>弧齿锥齿轮报告</translation>
  </message>
  <message>
   <source>Spiral bevel gears from the exact spherical involute: three ways to model the tooth flanks, side by side, and how far each is from theory.</source>
   <translation>基于精确球面渐开线的弧齿锥齿轮：三种齿面建模方法并列，以及各自与理论的差距。</translation>
  </message>
  <message>
   <source>Standard</source>
   <translation>标准收缩</translation>
  </message>
  <message>
   <source>Standard depth with a common apex; with constant clearance the face cone is turned parallel to the mate's root cone instead.</source>
   <translation>共锥顶的标准齿高；等顶隙时面锥平行于配对轮根锥。</translation>
  </message>
  <message>
   <source>Standard: root lines through the pitch apex. Uniform: the same depth from toe to heel. Duplex: constant slot width. Tilted root: constant slot width, but not steeper than 1.3 times standard.</source>
   <translation>标准：齿根线过节锥顶。等高：小端到大端齿高相同。双重：槽宽不变。倾斜齿根：槽宽不变，但不陡于标准的 1.3 倍。</translation>
  </message>
  <message>
   <source>Standards give the pressure angle in the normal section at the mean point, the paper in the transverse one.</source>
   <translation>标准给出中点法截面的压力角，论文给出端面的。</translation>
  </message>
  <message>
   <source>Start from the default design</source>
   <translation>从默认设计开始</translation>
  </message>
  <message>
   <source>State</source>
   <translation>状态</translation>
  </message>
  <message>
   <source>Steel</source>
   <translation>钢</translation>
  </message>
  <message>
   <source>Steps</source>
   <translation>级数</translation>
  </message>
  <message>
   <source>Stop making the report</source>
   <translation>停止生成报告</translation>
  </message>
  <message>
   <source>Stop the work in progress</source>
   <translation>停止正在进行的工作</translation>
  </message>
  <message>
   <source>Stop the work in progress (Esc)</source>
   <translation>停止正在进行的工作 (Esc)</translation>
  </message>
  <message>
   <source>Stopped</source>
   <translation>已停止</translation>
  </message>
  <message>
   <source>Straight bevel pair</source>
   <translation>直齿锥齿轮副</translation>
  </message>
  <message>
   <source>Stripes</source>
   <translation>条纹</translation>
  </message>
  <message>
   <source>Surface or difference</source>
   <translation>曲面或差值</translation>
  </message>
  <message>
   <source>Surface quality</source>
   <translation>曲面质量</translation>
  </message>
  <message>
   <source>Symbol</source>
   <translation>符号</translation>
  </message>
  <message>
   <source>Take away the other side</source>
   <translation>去除另一侧</translation>
  </message>
  <message>
   <source>Take away what lies beyond a plane and show the cut face</source>
   <translation>去除平面之外的部分并显示截面</translation>
  </message>
  <message>
   <source>Take back the last edit</source>
   <translation>撤销上次修改</translation>
  </message>
  <message>
   <source>Take colour and opacity back</source>
   <translation>恢复颜色和不透明度</translation>
  </message>
  <message>
   <source>Take over</source>
   <translation>接管</translation>
  </message>
  <message>
   <source>Take the changed file</source>
   <translation>采用已更改的文件</translation>
  </message>
  <message>
   <source>Take the marker away (Esc)</source>
   <translation>移除标记 (Esc)</translation>
  </message>
  <message>
   <source>Tangent plane</source>
   <translation>切平面</translation>
  </message>
  <message>
   <source>Taper</source>
   <translation>收缩方式</translation>
  </message>
  <message>
   <source>Taper of the wheel</source>
   <translation>大轮的收缩</translation>
  </message>
  <message>
   <source>Teeth</source>
   <translation>齿数</translation>
  </message>
  <message>
   <source>Teeth as long as the CAD flank is curved</source>
   <translation>梳齿长度与 CAD 齿面曲率成正比</translation>
  </message>
  <message>
   <source>Teeth measured</source>
   <translation>已测齿数</translation>
  </message>
  <message>
   <source>Text</source>
   <translation>文本</translation>
  </message>
  <message>
   <source>The 3D view could not be loaded.</source>
   <translation>无法加载 3D 视图。</translation>
  </message>
  <message>
   <source>The 3D views are switched off in the preferences (graphics).</source>
   <translation>3D 视图已在首选项（图形）中关闭。</translation>
  </message>
  <message>
   <source>The CAD kernel could not be started. Model ▸ Restart CAD kernel tries again.</source>
   <translation>无法启动 CAD 内核。可用“模型 ▸ 重启 CAD 内核”重试。</translation>
  </message>
  <message>
   <source>The CAD kernel stopped twice at the same work ({work}), which was given up. It is started again for everything else; change something before you try this again.</source>
   <translation>CAD 内核在同一项工作（{work}）上两次停止，该工作已放弃。内核正为其他工作重新启动；再次尝试之前请先作些更改。</translation>
  </message>
  <message>
   <source>The CAD kernel stopped unexpectedly ({work}). It is being started again and then tries this once more; nothing of the design is lost.</source>
   <translation>CAD 内核意外停止（{work}）。正在重新启动，随后会再试一次；设计没有任何丢失。</translation>
  </message>
  <message>
   <source>The CAD kernel stopped unexpectedly ({work}). It was started again and has done this now; nothing is lost.</source>
   <translation>CAD 内核意外停止（{work}）。已重新启动并完成了这项工作；没有任何丢失。</translation>
  </message>
  <message>
   <source>The CAD kernel stopped unexpectedly ({work}). It was started again and tries this once more; nothing of the design is lost.</source>
   <translation>CAD 内核意外停止（{work}）。已重新启动，正在再试一次；设计没有任何丢失。</translation>
  </message>
  <message>
   <source>The CAD kernel stopped unexpectedly and is being started again; nothing of the design is lost.</source>
   <translation>CAD 内核意外停止，正在重新启动；设计没有任何丢失。</translation>
  </message>
  <message>
   <source>The CAD kernel stopped unexpectedly and was started again; nothing of the design is lost.</source>
   <translation>CAD 内核意外停止，已重新启动；设计没有任何丢失。</translation>
  </message>
  <message>
   <source>The CAD process had grown to {size} MB and was started anew; nothing is lost.</source>
   <translation>CAD 进程增至 {size} MB，已重新启动；没有丢失。</translation>
  </message>
  <message>
   <source>The analysis could not be loaded.</source>
   <translation>无法加载分析。</translation>
  </message>
  <message>
   <source>The axis that viewers take as up is y, as glTF asks; z keeps the gear's own axes</source>
   <translation>查看器以 y 为上（glTF 要求）；选 z 则保留齿轮自身坐标轴</translation>
  </message>
  <message>
   <source>The azimuth β is where the point is, the roll angle Θ is how far the plane rolled: not the same angle.</source>
   <translation>方位角 β 是点的位置，滚动角 Θ 是平面滚过的量：不是同一个角。</translation>
  </message>
  <message>
   <source>The basis functions then do not add up to one.</source>
   <translation>此时基函数之和不为一。</translation>
  </message>
  <message>
   <source>The best fit may shift the part along its axis</source>
   <translation>最佳拟合可沿轴移动零件</translation>
  </message>
  <message>
   <source>The best fit may turn the part about its axis</source>
   <translation>最佳拟合可绕轴转动零件</translation>
  </message>
  <message>
   <source>The best fit might {ways}.</source>
   <translation>最佳拟合允许{ways}。</translation>
  </message>
  <message>
   <source>The chart was not saved: {error}</source>
   <translation>图表未保存：{error}</translation>
  </message>
  <message>
   <source>The cone on which the generating plane rolls.</source>
   <translation>生成平面在其上滚动的锥。</translation>
  </message>
  <message>
   <source>The cone on which the plane rolls</source>
   <translation>平面在其上滚动的锥</translation>
  </message>
  <message>
   <source>The cone that rolls on the mate's</source>
   <translation>与配对轮节锥相互滚动的锥</translation>
  </message>
  <message>
   <source>The construction as printed: few positions, two profiles, 7 × 7 points</source>
   <translation>按论文的构造：少量位置、两条齿廓、7 × 7 点</translation>
  </message>
  <message>
   <source>The construction whose surfaces are written</source>
   <translation>写出其曲面的构造方法</translation>
  </message>
  <message>
   <source>The contact could not be analysed; see the notes.</source>
   <translation>无法分析接触；见备注。</translation>
  </message>
  <message>
   <source>The cutter's radius is missing below the line.</source>
   <translation>分母中缺少刀盘半径。</translation>
  </message>
  <message>
   <source>The data sheet was not saved: {error}</source>
   <translation>数据表未保存：{error}</translation>
  </message>
  <message>
   <source>The design</source>
   <translation>设计</translation>
  </message>
  <message>
   <source>The design is not saved, so there is no folder in which exports could be.</source>
   <translation>设计尚未保存，因此没有可存放导出文件的文件夹。</translation>
  </message>
  <message>
   <source>The design to compare with</source>
   <translation>用于比较的设计</translation>
  </message>
  <message>
   <source>The designs cannot be compared: {reason}</source>
   <translation>无法比较设计：{reason}</translation>
  </message>
  <message>
   <source>The deviations that the paper states of its own gear, for comparison</source>
   <translation>论文给出的其自身齿轮的偏差，供比较</translation>
  </message>
  <message>
   <source>The division by the cosine does not agree with equation (7).</source>
   <translation>除以余弦与公式 (7) 不符。</translation>
  </message>
  <message>
   <source>The equation</source>
   <translation>公式</translation>
  </message>
  <message>
   <source>The equation of the parameter or row with the cursor</source>
   <translation>光标所在参数或行的公式</translation>
  </message>
  <message>
   <source>The exact flank, translucent</source>
   <translation>精确齿面，半透明</translation>
  </message>
  <message>
   <source>The export failed: {text}</source>
   <translation>导出失败：{text}</translation>
  </message>
  <message>
   <source>The face cone touches a plane on the wheel's root cone, the root cone one on its face cone, both the clearance away.</source>
   <translation>面锥与大轮根锥的切平面相切，根锥与其面锥的切平面相切，两者均相隔顶隙。</translation>
  </message>
  <message>
   <source>The face width is given as a length: empty that field to use the factor.</source>
   <translation>齿宽已按长度给出：清空该字段以使用系数。</translation>
  </message>
  <message>
   <source>The flank</source>
   <translation>齿面</translation>
  </message>
  <message>
   <source>The flanks of the three methods in perspective</source>
   <translation>三种方法齿面的透视图</translation>
  </message>
  <message>
   <source>The folder of “{name}” is no longer there:
{folder}</source>
   <translation>“{name}”的文件夹已不存在：
{folder}</translation>
  </message>
  <message>
   <source>The formulas used, the paper's departures, and this design's numbers</source>
   <translation>所用公式、与论文的不同及本设计的数值</translation>
  </message>
  <message>
   <source>The generating line, moved rigidly as the tangent plane rolls on the base cone</source>
   <translation>母线随切平面在基锥上滚动作刚体运动</translation>
  </message>
  <message>
   <source>The generating line, rolled by Θ, lies on the flank to 4·10⁻¹⁴ mm.</source>
   <translation>滚动 Θ 后的母线与齿面吻合到 4·10⁻¹⁴ mm。</translation>
  </message>
  <message>
   <source>The inclination of the flank that would slide along the tooth alone: drive and coast flank lie equally far from it.</source>
   <translation>只沿齿向滑动的齿面的倾角：正驱动面和反驱动面与它的距离相等。</translation>
  </message>
  <message>
   <source>The kernel's full check of the solid</source>
   <translation>内核对实体的完整检查</translation>
  </message>
  <message>
   <source>The language that the report is written in</source>
   <translation>报告所用的语言</translation>
  </message>
  <message>
   <source>The last column says where the formula stands: section of the theory, and in brackets the paper's equation.</source>
   <translation>最后一列给出公式的出处：理论的章节，括号内为论文的公式号。</translation>
  </message>
  <message>
   <source>The line in the plane, and the flank it has swept</source>
   <translation>平面内的直线及其扫出的齿面</translation>
  </message>
  <message>
   <source>The mate's tip must not roll beyond the start of the flank on the base cone.</source>
   <translation>配对轮齿顶不得滚过齿面在基锥上的起点。</translation>
  </message>
  <message>
   <source>The measured points could not be compared with this design; see the notes.</source>
   <translation>测点无法与本设计比较；见备注。</translation>
  </message>
  <message>
   <source>The measurement was cancelled.</source>
   <translation>测量已取消。</translation>
  </message>
  <message>
   <source>The measuring grid with a bar at each point, both flanks</source>
   <translation>测量网格，每点一柱，两侧齿面</translation>
  </message>
  <message>
   <source>The member that is drawn</source>
   <translation>所绘制的齿轮</translation>
  </message>
  <message>
   <source>The member, or both where they mesh</source>
   <translation>单个齿轮，或啮合的两轮</translation>
  </message>
  <message>
   <source>The methods are being built…</source>
   <translation>正在构建各方法…</translation>
  </message>
  <message>
   <source>The methods side by side, charts, tooth contact, the data sheet, and measured points.</source>
   <translation>方法并列比较、图表、齿面接触、数据表和测点。</translation>
  </message>
  <message>
   <source>The modified flank</source>
   <translation>修形齿面</translation>
  </message>
  <message>
   <source>The nominal grid was not saved: {reason}</source>
   <translation>名义网格未保存：{reason}</translation>
  </message>
  <message>
   <source>The offset</source>
   <translation>偏置距</translation>
  </message>
  <message>
   <source>The opposite flank</source>
   <translation>另一侧齿面</translation>
  </message>
  <message>
   <source>The optimised variants refine until they expect to be below it.</source>
   <translation>优化方案细化到预期低于此值。</translation>
  </message>
  <message>
   <source>The other flank of the tooth is the mirror image about the tooth's middle.</source>
   <translation>齿的另一侧齿面是关于齿中面的镜像。</translation>
  </message>
  <message>
   <source>The other teeth and the body, in light grey</source>
   <translation>其余齿和轮体，浅灰色</translation>
  </message>
  <message>
   <source>The pair</source>
   <translation>齿轮副</translation>
  </message>
  <message>
   <source>The pair in mesh</source>
   <translation>啮合中的齿轮副</translation>
  </message>
  <message>
   <source>The paper prints</source>
   <translation>论文印为</translation>
  </message>
  <message>
   <source>The paper turns the flank.</source>
   <translation>论文旋转了齿面。</translation>
  </message>
  <message>
   <source>The paper: mean deviation of its three methods; the data of its gear are not printed</source>
   <translation>论文：三种方法的平均偏差；其齿轮数据未给出</translation>
  </message>
  <message>
   <source>The parameters that differ, as they were saved and as they were recovered</source>
   <translation>不同的参数：保存的值和恢复的值</translation>
  </message>
  <message>
   <source>The picture is on the clipboard</source>
   <translation>图片已在剪贴板</translation>
  </message>
  <message>
   <source>The pinion's concave flank leads</source>
   <translation>小轮凹面主动</translation>
  </message>
  <message>
   <source>The pinion's conjugate flank</source>
   <translation>小轮的共轭齿面</translation>
  </message>
  <message>
   <source>The pinion's convex flank leads</source>
   <translation>小轮凸面主动</translation>
  </message>
  <message>
   <source>The pinion's flanks as the wheel makes them</source>
   <translation>由大轮生成的小轮齿面</translation>
  </message>
  <message>
   <source>The pitch angles are those for which it is the radius of the wheel's tooth trace: r₀ for a cutter's arc.</source>
   <translation>节锥角的取值使其等于大轮齿线的半径：刀盘圆弧时为 r₀ 。</translation>
  </message>
  <message>
   <source>The pitch cones of two gears with crossing axes roll on each other; z' are the mate's teeth. For a right angle it is the paper's arctan z / z'.</source>
   <translation>相交轴两轮的节锥相互滚动；z' 为配对轮齿数。直角时即论文的 arctan z / z'。</translation>
  </message>
  <message>
   <source>The point of the flank under the pointer</source>
   <translation>指针下的齿面点</translation>
  </message>
  <message>
   <source>The printed bound does not return the spiral angle it is made from.</source>
   <translation>印刷的界限不能还原其来源的螺旋角。</translation>
  </message>
  <message>
   <source>The printed form is a length, not a number; the used one meets tan β = ρ ψ′(ρ) to 10⁻⁸.</source>
   <translation>印刷形式是长度而非数；采用的形式满足 tan β = ρ ψ′(ρ)，精度 10⁻⁸。</translation>
  </message>
  <message>
   <source>The printed form is a ratio of lengths, not a count.</source>
   <translation>印刷形式是长度之比，不是个数。</translation>
  </message>
  <message>
   <source>The process that builds flanks and solids</source>
   <translation>构建齿面和实体的进程</translation>
  </message>
  <message>
   <source>The publication does not print the data from which it could be computed</source>
   <translation>出版物未给出计算所需的数据</translation>
  </message>
  <message>
   <source>The report could not be made: the CAD kernel stopped. {reason}</source>
   <translation>无法生成报告：CAD 内核已停止。{reason}</translation>
  </message>
  <message>
   <source>The report could not be made: {reason}</source>
   <translation>无法生成报告：{reason}</translation>
  </message>
  <message>
   <source>The rolling plane's point</source>
   <translation>滚动平面上的点</translation>
  </message>
  <message>
   <source>The settings are reset; some take effect when GearStudio starts again.</source>
   <translation>设置已重置；部分在 GearStudio 下次启动时生效。</translation>
  </message>
  <message>
   <source>The settings file was damaged, so the window starts with the usual settings. {where}</source>
   <translation>设置文件已损坏，窗口以默认设置启动。{where}</translation>
  </message>
  <message>
   <source>The shortest distance between the axes, from the mean point's radii; a_p is the part in the pitch plane.</source>
   <translation>两轴间的最短距离，由中点的半径求得； a_p 为节平面内的部分。</translation>
  </message>
  <message>
   <source>The standard taper: root lines through the pitch apex. With uniform depth both angles are 0; duplex and tilted root divide another sum of the dedendum angles as the depth is divided; an angle that is given wins.</source>
   <translation>标准收缩：齿根线通过节锥顶。等高齿两角均为 0；双重收缩和倾斜齿根按齿高的分配划分另一齿根角之和；给定的角优先。</translation>
  </message>
  <message>
   <source>The step before</source>
   <translation>上一步</translation>
  </message>
  <message>
   <source>The sum divides by zero</source>
   <translation>算式除以零</translation>
  </message>
  <message>
   <source>The sum has no finite value</source>
   <translation>算式没有有限值</translation>
  </message>
  <message>
   <source>The sum has no value: look at the arguments of its functions</source>
   <translation>算式无值：请检查函数的参数</translation>
  </message>
  <message>
   <source>The sum is longer than {count} characters</source>
   <translation>算式超过 {count} 个字符</translation>
  </message>
  <message>
   <source>The sum of the dedendum angles for which both slots keep their width along the face; κ is the tooth trace's curvature. A tilted root line takes at most 1.3 times the standard sum.</source>
   <translation>使两轮齿槽沿齿宽保持槽宽不变的齿根角之和； κ 为齿线的曲率。倾斜齿根线至多取标准之和的 1.3 倍。</translation>
  </message>
  <message>
   <source>The system refused to start another window.</source>
   <translation>系统拒绝打开另一个窗口。</translation>
  </message>
  <message>
   <source>The teeth end square to the pitch cone: ρ_u is the cone distance there, and points above and below are farther from the apex.</source>
   <translation>轮齿终止于垂直于节锥的面： ρ_u 为该处锥距，其上下的点离锥顶更远。</translation>
  </message>
  <message>
   <source>The teeth run along each other at the mean point, the cones' elements do not.</source>
   <translation>在中点，两轮的轮齿方向一致，而两锥的母线方向不一致。</translation>
  </message>
  <message>
   <source>The theoretical surface, explicit in azimuth: the deviation of any point from it needs no search.</source>
   <translation>理论曲面以方位角显式表达：任意点的偏差无需搜索。</translation>
  </message>
  <message>
   <source>The thickness factor makes the pinion's teeth thicker and the wheel's thinner; x_sm has the backlash's share.</source>
   <translation>齿厚系数使小轮齿变厚、大轮齿变薄； x_sm 含侧隙份额。</translation>
  </message>
  <message>
   <source>The three methods side by side, seen from the same place</source>
   <translation>三种方法并列，同一视角</translation>
  </message>
  <message>
   <source>The tips run parallel to the mate's root cone, through the tip's corner at the heel; the face cone has an apex of its own.</source>
   <translation>齿顶平行于配对轮根锥，并通过大端齿顶角点；面锥有自己的锥顶。</translation>
  </message>
  <message>
   <source>The tooth is self-similar: every section is the heel's, scaled by ρ and turned by θ(ρ).</source>
   <translation>齿是自相似的：每个截面都是大端截面按 ρ 缩放并转 θ(ρ)。</translation>
  </message>
  <message>
   <source>The tooth profile, swept from heel to toe along the tooth trace</source>
   <translation>齿廓沿齿线由大端扫掠到小端</translation>
  </message>
  <message>
   <source>The tooth that is drawn</source>
   <translation>所绘制的齿</translation>
  </message>
  <message>
   <source>The turn of the wheel over its pitch: while contact moves over the profile in the middle of the face (ε_α), along the face at half the depth (ε_β), and over the whole flank (ε_γ).</source>
   <translation>大轮转角与其齿距之比：接触经过齿宽中部的齿廓时 (ε_α) 、在半齿高处沿齿宽时 (ε_β) ，以及经过整个齿面时 (ε_γ) 。</translation>
  </message>
  <message>
   <source>The turn θ(ρ) is missing.</source>
   <translation>缺少转角 θ(ρ)。</translation>
  </message>
  <message>
   <source>The views</source>
   <translation>视图</translation>
  </message>
  <message>
   <source>The weights are missing above the line.</source>
   <translation>分子中缺少权重。</translation>
  </message>
  <message>
   <source>The wheel's mean addendum over working depth; leave empty for 0.21 + 0.29/u₉₀².</source>
   <translation>大轮中点齿顶高与工作齿高之比；留空为 0.21 + 0.29/u₉₀²。</translation>
  </message>
  <message>
   <source>The whole window</source>
   <translation>整个窗口</translation>
  </message>
  <message>
   <source>The window alone on the screen, and back</source>
   <translation>窗口全屏与恢复</translation>
  </message>
  <message>
   <source>The window changes its language at once; the design and its results stay as they are.</source>
   <translation>窗口立即切换语言；设计和结果保持不变。</translation>
  </message>
  <message>
   <source>The words of the field, as they are used here</source>
   <translation>本程序所用的专业词汇</translation>
  </message>
  <message>
   <source>The {flank} flank</source>
   <translation>{flank}齿面</translation>
  </message>
  <message>
   <source>Theme</source>
   <translation>主题</translation>
  </message>
  <message>
   <source>Theoretical flank</source>
   <translation>理论齿面</translation>
  </message>
  <message>
   <source>Theory</source>
   <translation>理论</translation>
  </message>
  <message>
   <source>Theory, section {section}</source>
   <translation>理论，第 {section} 节</translation>
  </message>
  <message>
   <source>There are no backups yet; each save of a design makes one.</source>
   <translation>尚无备份；每次保存设计都会产生一份。</translation>
  </message>
  <message>
   <source>There are no exports with a record in {folder}.</source>
   <translation>{folder} 中没有带记录的导出文件。</translation>
  </message>
  <message>
   <source>There is no unsaved work to recover.</source>
   <translation>没有可恢复的未保存工作。</translation>
  </message>
  <message>
   <source>There is no {field} to begin or end.</source>
   <translation>没有{field}，起止点无意义。</translation>
  </message>
  <message>
   <source>There was no best fit.</source>
   <translation>未作最佳拟合。</translation>
  </message>
  <message>
   <source>These are the values of an earlier design; of this one there are none: {error}</source>
   <translation>这是先前设计的值；当前设计没有：{error}</translation>
  </message>
  <message>
   <source>These panels share a place while the window is narrow</source>
   <translation>窗口较窄时，这些面板共用一个位置</translation>
  </message>
  <message>
   <source>These sizes make no blank; the field says why.</source>
   <translation>这些尺寸不能构成轮坯；原因见该字段。</translation>
  </message>
  <message>
   <source>They are lost if you do not save them.</source>
   <translation>不保存则会丢失。</translation>
  </message>
  <message>
   <source>Thickness</source>
   <translation>齿厚</translation>
  </message>
  <message>
   <source>Thickness and chord</source>
   <translation>齿厚与弦长</translation>
  </message>
  <message>
   <source>Thickness factor</source>
   <translation>齿厚系数</translation>
  </message>
  <message>
   <source>Thickness modification coefficient</source>
   <translation>齿厚修正系数</translation>
  </message>
  <message>
   <source>Thickness of the marking compound: where the gap is less, it is wiped off</source>
   <translation>涂料厚度：间隙小于此处被擦去</translation>
  </message>
  <message>
   <source>Thickness of the tip; where it is not positive the tooth is pointed.</source>
   <translation>齿顶的厚度；不为正处齿顶变尖。</translation>
  </message>
  <message>
   <source>Thickness that the pinion's teeth gain over the wheel's, over mean normal module.</source>
   <translation>小轮齿比大轮齿多出的厚度与中点法向模数之比。</translation>
  </message>
  <message>
   <source>This design</source>
   <translation>本设计</translation>
  </message>
  <message>
   <source>This design has no complete tooth; see the notes.</source>
   <translation>本设计没有完整的轮齿；见备注。</translation>
  </message>
  <message>
   <source>This design was never saved.</source>
   <translation>此设计从未保存。</translation>
  </message>
  <message>
   <source>This display offers no OpenGL.</source>
   <translation>此显示不支持 OpenGL。</translation>
  </message>
  <message>
   <source>This parameter enters no equation.</source>
   <translation>此参数不进入任何公式。</translation>
  </message>
  <message>
   <source>This solid</source>
   <translation>此实体</translation>
  </message>
  <message>
   <source>Three methods, two variants</source>
   <translation>三种方法，两种方案</translation>
  </message>
  <message>
   <source>Tick a format to see how it can be written.</source>
   <translation>勾选格式以查看其写出选项。</translation>
  </message>
  <message>
   <source>Tilted root</source>
   <translation>倾斜齿根</translation>
  </message>
  <message>
   <source>Time</source>
   <translation>时间</translation>
  </message>
  <message>
   <source>Time [ms]</source>
   <translation>时间 [ms]</translation>
  </message>
  <message>
   <source>Time to build both flanks</source>
   <translation>构建两侧齿面的时间</translation>
  </message>
  <message>
   <source>Tip and root</source>
   <translation>齿顶与齿根</translation>
  </message>
  <message>
   <source>Tip clearance at the heel over outer module.</source>
   <translation>大端顶隙与大端模数之比。</translation>
  </message>
  <message>
   <source>Tip clearance over working depth.</source>
   <translation>顶隙与工作齿高之比。</translation>
  </message>
  <message>
   <source>Tip cone</source>
   <translation>面锥</translation>
  </message>
  <message>
   <source>Tip land</source>
   <translation>齿顶厚</translation>
  </message>
  <message>
   <source>Tip land, heel</source>
   <translation>齿顶厚，大端</translation>
  </message>
  <message>
   <source>Tip land, toe</source>
   <translation>齿顶厚，小端</translation>
  </message>
  <message>
   <source>Tip relief</source>
   <translation>齿顶修缘</translation>
  </message>
  <message>
   <source>Tip relief starts at</source>
   <translation>齿顶修缘起点</translation>
  </message>
  <message>
   <source>Tip, fillets, root and ends of the tooth, in light grey</source>
   <translation>齿顶、圆角、齿根和齿端，浅灰色</translation>
  </message>
  <message>
   <source>Titles, axes and scale bar</source>
   <translation>标题、坐标轴和比例尺</translation>
  </message>
  <message>
   <source>To [{unit}]</source>
   <translation>到 [{unit}]</translation>
  </message>
  <message>
   <source>To draw without a graphics card, start GearStudio with: --graphics software</source>
   <translation>无显卡绘图请用 --graphics software 启动 GearStudio</translation>
  </message>
  <message>
   <source>Toe – heel</source>
   <translation>小端 – 大端</translation>
  </message>
  <message>
   <source>Toe, base cone</source>
   <translation>小端，基锥</translation>
  </message>
  <message>
   <source>Tolerance</source>
   <translation>公差</translation>
  </message>
  <message>
   <source>Tooth</source>
   <translation>齿</translation>
  </message>
  <message>
   <source>Tooth contact</source>
   <translation>齿面接触</translation>
  </message>
  <message>
   <source>Tooth ends</source>
   <translation>齿端</translation>
  </message>
  <message>
   <source>Tooth form</source>
   <translation>齿形</translation>
  </message>
  <message>
   <source>Tooth profile</source>
   <translation>齿廓</translation>
  </message>
  <message>
   <source>Tooth trace of a cutter</source>
   <translation>刀盘齿线</translation>
  </message>
  <message>
   <source>Tooth {number}</source>
   <translation>第 {number} 齿</translation>
  </message>
  <message>
   <source>Topography</source>
   <translation>拓扑图</translation>
  </message>
  <message>
   <source>Total contact ratio</source>
   <translation>总重合度</translation>
  </message>
  <message>
   <source>Tour</source>
   <translation>导览</translation>
  </message>
  <message>
   <source>Transmission error</source>
   <translation>传动误差</translation>
  </message>
  <message>
   <source>Transmission error over three pitches.</source>
   <translation>三个齿距内的传动误差。</translation>
  </message>
  <message>
   <source>Transmission error, peak to peak [″]</source>
   <translation>传动误差峰峰值 [″]</translation>
  </message>
  <message>
   <source>Transparent background</source>
   <translation>透明背景</translation>
  </message>
  <message>
   <source>Transverse</source>
   <translation>端面</translation>
  </message>
  <message>
   <source>Transverse backlash at the heel pitch circle, half from each member.</source>
   <translation>大端节圆上的端面侧隙，两轮各半。</translation>
  </message>
  <message>
   <source>Transverse backlash, outer</source>
   <translation>端面侧隙，大端</translation>
  </message>
  <message>
   <source>Transverse chordal thickness, outer</source>
   <translation>端面弦齿厚，大端</translation>
  </message>
  <message>
   <source>Transverse circular thickness, mean</source>
   <translation>端面弧齿厚，中点</translation>
  </message>
  <message>
   <source>Transverse circular thickness, outer</source>
   <translation>端面弧齿厚，大端</translation>
  </message>
  <message>
   <source>Transverse contact ratio</source>
   <translation>端面重合度</translation>
  </message>
  <message>
   <source>Transverse contact ratio on the heel sphere, and overlap ratio.</source>
   <translation>大端球面上的端面重合度，以及轴向重合度。</translation>
  </message>
  <message>
   <source>Transverse pressure angle</source>
   <translation>端面压力角</translation>
  </message>
  <message>
   <source>Triangles within</source>
   <translation>三角形公差</translation>
  </message>
  <message>
   <source>Turn</source>
   <translation>转动</translation>
  </message>
  <message>
   <source>Turn of the pinion</source>
   <translation>小轮转角</translation>
  </message>
  <message>
   <source>Turn of the spiral from toe to heel</source>
   <translation>螺旋从小端到大端的转角</translation>
  </message>
  <message>
   <source>Turn the pair in mesh</source>
   <translation>转动啮合齿轮副</translation>
  </message>
  <message>
   <source>Turn the views together, or each by itself</source>
   <translation>各视图一起转动，或各自转动</translation>
  </message>
  <message>
   <source>Turned by</source>
   <translation>转动量</translation>
  </message>
  <message>
   <source>Turned by the best fit</source>
   <translation>最佳拟合的转动量</translation>
  </message>
  <message>
   <source>Turns the lamps</source>
   <translation>转动灯</translation>
  </message>
  <message>
   <source>Turntable</source>
   <translation>转台</translation>
  </message>
  <message>
   <source>Two equal gears at 90° with the Archimedean spiral, the spiral angle given at the toe as in the paper</source>
   <translation>90° 两相同齿轮，阿基米德螺旋线，螺旋角按论文在小端给出</translation>
  </message>
  <message>
   <source>Type a command or a parameter</source>
   <translation>键入命令或参数</translation>
  </message>
  <message>
   <source>Type the range…</source>
   <translation>输入范围…</translation>
  </message>
  <message>
   <source>Undercut margin</source>
   <translation>根切裕量</translation>
  </message>
  <message>
   <source>Undercut margin: rolled arc left below the mate's tip</source>
   <translation>根切裕量：配对轮齿顶以下剩余的滚动弧</translation>
  </message>
  <message>
   <source>Undercut of the pinion</source>
   <translation>小轮的根切</translation>
  </message>
  <message>
   <source>Undone: {step}</source>
   <translation>已撤销：{step}</translation>
  </message>
  <message>
   <source>Unexpected error</source>
   <translation>意外错误</translation>
  </message>
  <message>
   <source>Unfold all groups</source>
   <translation>展开所有组</translation>
  </message>
  <message>
   <source>Uniform</source>
   <translation>等高</translation>
  </message>
  <message>
   <source>Unit</source>
   <translation>单位</translation>
  </message>
  <message>
   <source>Unit of deviations on the colour scale and in the views</source>
   <translation>色标和视图中偏差的单位</translation>
  </message>
  <message>
   <source>Unit of length in the file; the gear keeps its size</source>
   <translation>文件的长度单位；齿轮尺寸不变</translation>
  </message>
  <message>
   <source>Units, colours and language</source>
   <translation>单位、颜色和语言</translation>
  </message>
  <message>
   <source>Units, theme, language, memory and keys</source>
   <translation>单位、主题、语言、内存和快捷键</translation>
  </message>
  <message>
   <source>Unnamed pair</source>
   <translation>未命名齿轮副</translation>
  </message>
  <message>
   <source>Unsaved changes</source>
   <translation>未保存的修改</translation>
  </message>
  <message>
   <source>Unsaved edits cannot be kept for recovery: {reason}</source>
   <translation>未保存的修改无法保留以供恢复：{reason}</translation>
  </message>
  <message>
   <source>Untitled</source>
   <translation>未命名</translation>
  </message>
  <message>
   <source>Up to date</source>
   <translation>最新</translation>
  </message>
  <message>
   <source>Up to ± [{unit}]</source>
   <translation>至 ± [{unit}]</translation>
  </message>
  <message>
   <source>Upper end of the scale</source>
   <translation>色标上限</translation>
  </message>
  <message>
   <source>Used by: {parameters}</source>
   <translation>所用参数：{parameters}</translation>
  </message>
  <message>
   <source>Usual</source>
   <translation>常用</translation>
  </message>
  <message>
   <source>Valid</source>
   <translation>有效</translation>
  </message>
  <message>
   <source>Value</source>
   <translation>值</translation>
  </message>
  <message>
   <source>Values at the picked point</source>
   <translation>所选点的值</translation>
  </message>
  <message>
   <source>Values with a unit can be added, but not multiplied with each other</source>
   <translation>带单位的值可相加，但不能相乘</translation>
  </message>
  <message>
   <source>Variant</source>
   <translation>方案</translation>
  </message>
  <message>
   <source>Verdict</source>
   <translation>结论</translation>
  </message>
  <message>
   <source>Views</source>
   <translation>视图</translation>
  </message>
  <message>
   <source>Virtual normal diameter, mean</source>
   <translation>法向当量直径，中点</translation>
  </message>
  <message>
   <source>Volume</source>
   <translation>体积</translation>
  </message>
  <message>
   <source>Volume, mass and moments of the solids that are built</source>
   <translation>已构建实体的体积、质量和惯量</translation>
  </message>
  <message>
   <source>Warning</source>
   <translation>警告</translation>
  </message>
  <message>
   <source>Warning: {message}.</source>
   <translation>警告：{message}。</translation>
  </message>
  <message>
   <source>Warnings and errors</source>
   <translation>警告和错误</translation>
  </message>
  <message>
   <source>Web thickness</source>
   <translation>辐板厚度</translation>
  </message>
  <message>
   <source>Weights above and below the line.</source>
   <translation>分子分母均有权重。</translation>
  </message>
  <message>
   <source>What colours the CAD flanks</source>
   <translation>CAD 齿面着色依据</translation>
  </message>
  <message>
   <source>What draws the 3D views</source>
   <translation>3D 视图的绘制方式</translation>
  </message>
  <message>
   <source>What else is known</source>
   <translation>其他已知信息</translation>
  </message>
  <message>
   <source>What follows from the parameters</source>
   <translation>由参数导出的值</translation>
  </message>
  <message>
   <source>What is drawn: deviation, exact flank, sections and points, and how the flank comes about.</source>
   <translation>绘制的内容：偏差、精确齿面、截面和点，以及齿面的生成。</translation>
  </message>
  <message>
   <source>What is in the picture</source>
   <translation>图片内容</translation>
  </message>
  <message>
   <source>What is this?</source>
   <translation>这是什么？</translation>
  </message>
  <message>
   <source>What is written over the views</source>
   <translation>视图上的文字</translation>
  </message>
  <message>
   <source>What is wrong with the parameters</source>
   <translation>参数的问题</translation>
  </message>
  <message>
   <source>What moves in the film</source>
   <translation>影片中的运动</translation>
  </message>
  <message>
   <source>What of it</source>
   <translation>哪一部分</translation>
  </message>
  <message>
   <source>What others printed, computed again</source>
   <translation>他人发表的值，重新计算</translation>
  </message>
  <message>
   <source>What the construction took</source>
   <translation>构造所用的参数</translation>
  </message>
  <message>
   <source>What the contact is computed for, and its numbers</source>
   <translation>接触计算的条件及其数值</translation>
  </message>
  <message>
   <source>What the lamps are fixed to</source>
   <translation>灯固定于</translation>
  </message>
  <message>
   <source>What the program noted, the newest last</source>
   <translation>程序记录，最新在末尾</translation>
  </message>
  <message>
   <source>What this design is called.</source>
   <translation>此设计的名称。</translation>
  </message>
  <message>
   <source>What this is, and the versions of its parts</source>
   <translation>本程序及其组件版本</translation>
  </message>
  <message>
   <source>What was made and what was found, for “gearstudio verify”</source>
   <translation>所做与所检结果，供“gearstudio verify”使用</translation>
  </message>
  <message>
   <source>What was written beside the project, and what was found on reading it back</source>
   <translation>写在项目旁的内容及回读结果</translation>
  </message>
  <message>
   <source>Wheel</source>
   <translation>大轮</translation>
  </message>
  <message>
   <source>Wheel along its axis, positive away from the crossing point</source>
   <translation>大轮沿其轴线，离开轴线交点为正</translation>
  </message>
  <message>
   <source>Wheel axis along +z; the flanks are exactly conjugate.</source>
   <translation>大轮轴沿 +z；齿面精确共轭。</translation>
  </message>
  <message>
   <source>Wheel blank</source>
   <translation>大轮轮坯</translation>
  </message>
  <message>
   <source>Wheel teeth</source>
   <translation>大轮齿数</translation>
  </message>
  <message>
   <source>Where each method deviates from the exact flank</source>
   <translation>各方法偏离精确齿面之处</translation>
  </message>
  <message>
   <source>Where the files are written</source>
   <translation>文件写到何处</translation>
  </message>
  <message>
   <source>Where the involutes start on the base cone</source>
   <translation>渐开线在基锥上的起点</translation>
  </message>
  <message>
   <source>Where the involutes start; the generating line is this curve unrolled into the tangent plane.</source>
   <translation>渐开线的起点；母线是此曲线在切平面上的展开。</translation>
  </message>
  <message>
   <source>Where the marking compound is wiped off</source>
   <translation>涂料被擦去之处</translation>
  </message>
  <message>
   <source>Where the plane of the section stands</source>
   <translation>剖切平面的位置</translation>
  </message>
  <message>
   <source>Where things are in the window, step by step</source>
   <translation>逐步介绍窗口中各部分的位置</translation>
  </message>
  <message>
   <source>Which entries are shown</source>
   <translation>显示哪些条目</translation>
  </message>
  <message>
   <source>Which method and which variant is shown: as the paper has it, or refined until it meets the tolerance.</source>
   <translation>显示哪种方法与方案：同论文，或细化到满足公差。</translation>
  </message>
  <message>
   <source>White</source>
   <translation>白</translation>
  </message>
  <message>
   <source>Whole gear</source>
   <translation>整个齿轮</translation>
  </message>
  <message>
   <source>With an offset the pressure angle is the normal one.</source>
   <translation>有偏置时压力角为法向的。</translation>
  </message>
  <message>
   <source>With an offset the spiral angle is given at the mean point.</source>
   <translation>有偏置时螺旋角在中点给出。</translation>
  </message>
  <message>
   <source>With an offset the tips run parallel to the mate's root: no apex is common.</source>
   <translation>有偏置时齿顶平行于配对轮齿根：没有共锥顶。</translation>
  </message>
  <message>
   <source>With the camera</source>
   <translation>随相机</translation>
  </message>
  <message>
   <source>With the gear</source>
   <translation>随齿轮</translation>
  </message>
  <message>
   <source>With the printed form equation (7) gives R = 222.2 mm instead of 86.9 mm (17/40 teeth, m = 4 mm, transverse 20°, wheel).</source>
   <translation>用印刷形式时公式 (7) 得 R = 222.2 mm 而非 86.9 mm（17/40 齿，m = 4 mm，端面 20°，大轮）。</translation>
  </message>
  <message>
   <source>With {value} no derived value would change.</source>
   <translation>取 {value} 时推导值均不变。</translation>
  </message>
  <message>
   <source>With {value}:</source>
   <translation>取 {value} 时：</translation>
  </message>
  <message>
   <source>Within {value}: {efforts}</source>
   <translation>达到 {value}：{efforts}</translation>
  </message>
  <message>
   <source>Without it the guide leaves the flank of a spiral tooth.</source>
   <translation>没有它，引导线会离开弧齿齿面。</translation>
  </message>
  <message>
   <source>Without misalignment, marking compound {thickness} µm thick; the least backlash while rolling is {play} mm. Drive: the pinion's concave flank leads. The centre of the pattern is given as a part of the face from the toe and of the profile from the root.</source>
   <translation>无安装误差，涂料厚度 {thickness} µm；滚动中的最小侧隙为 {play} mm。正驱动：小轮凹面主动。斑点中心以自小端起的齿宽比例和自齿根起的齿廓比例给出。</translation>
  </message>
  <message>
   <source>Words of the title or the text, or the paper's number</source>
   <translation>标题或正文中的词，或论文编号</translation>
  </message>
  <message>
   <source>Words of the window</source>
   <translation>窗口语言</translation>
  </message>
  <message>
   <source>Words of title, symbol, description or group</source>
   <translation>标题、符号、说明或组中的词</translation>
  </message>
  <message>
   <source>Work</source>
   <translation>工作</translation>
  </message>
  <message>
   <source>Working depth and clearance</source>
   <translation>工作齿高与顶隙</translation>
  </message>
  <message>
   <source>Working depth at the mean point over mean normal module.</source>
   <translation>中点工作齿高与中点法向模数之比。</translation>
  </message>
  <message>
   <source>Working flanks</source>
   <translation>工作齿面</translation>
  </message>
  <message>
   <source>Write flanks, teeth, gears or the pair for other programs</source>
   <translation>为其他程序写出齿面、齿、齿轮或齿轮副</translation>
  </message>
  <message>
   <source>Write the files and check them</source>
   <translation>写出并检查文件</translation>
  </message>
  <message>
   <source>Write the nominal points with normals, for a coordinate measuring machine</source>
   <translation>写出带法线的名义点，供三坐标测量机使用</translation>
  </message>
  <message>
   <source>Writes {names}</source>
   <translation>将写出 {names}</translation>
  </message>
  <message>
   <source>Written</source>
   <translation>写出</translation>
  </message>
  <message>
   <source>Wrote {names} to {folder}; read back and checked</source>
   <translation>已将 {names} 写到 {folder}；已回读并检查</translation>
  </message>
  <message>
   <source>Wrote {name} to {folder}</source>
   <translation>已将 {name} 写到 {folder}</translation>
  </message>
  <message>
   <source>Zebra stripes</source>
   <translation>斑马纹</translation>
  </message>
  <message>
   <source>Zerol pair</source>
   <translation>零度齿轮副</translation>
  </message>
  <message>
   <source>above pitch cone [mm]</source>
   <translation>高出节锥 [mm]</translation>
  </message>
  <message>
   <source>addendum</source>
   <translation>齿顶高</translation>
  </message>
  <message>
   <source>and {count} more</source>
   <translation>另有 {count} 项</translation>
  </message>
  <message>
   <source>apex to crown</source>
   <translation>锥顶至轮冠</translation>
  </message>
  <message>
   <source>at least {low}</source>
   <translation>至少 {low}</translation>
  </message>
  <message>
   <source>at most {high}</source>
   <translation>至多 {high}</translation>
  </message>
  <message>
   <source>at this cone distance</source>
   <translation>在此锥距处</translation>
  </message>
  <message>
   <source>axial face width</source>
   <translation>轴向齿宽</translation>
  </message>
  <message>
   <source>azimuth at the pitch cone</source>
   <translation>节锥处方位角</translation>
  </message>
  <message>
   <source>back face</source>
   <translation>背面</translation>
  </message>
  <message>
   <source>base</source>
   <translation>基</translation>
  </message>
  <message>
   <source>base angle</source>
   <translation>基锥角</translation>
  </message>
  <message>
   <source>basic render</source>
   <translation>基本渲染</translation>
  </message>
  <message>
   <source>best fit</source>
   <translation>最佳拟合</translation>
  </message>
  <message>
   <source>binary</source>
   <translation>二进制</translation>
  </message>
  <message>
   <source>body</source>
   <translation>轮体</translation>
  </message>
  <message>
   <source>bore</source>
   <translation>内孔</translation>
  </message>
  <message>
   <source>both flanks</source>
   <translation>两侧齿面</translation>
  </message>
  <message>
   <source>box {box} · read by {kernel}</source>
   <translation>包围盒 {box} · 由 {kernel} 读回</translation>
  </message>
  <message>
   <source>building…</source>
   <translation>构建中…</translation>
  </message>
  <message>
   <source>by the taper</source>
   <translation>由收缩方式</translation>
  </message>
  <message>
   <source>c_e = h_fe − h_ae of the mate</source>
   <translation>c_e = h_fe − 配对轮 h_ae</translation>
  </message>
  <message>
   <source>c_i = h_fi − h_ai of the mate</source>
   <translation>c_i = h_fi − 配对轮 h_ai</translation>
  </message>
  <message>
   <source>c_m = h_fm − h_am of the mate</source>
   <translation>c_m = h_fm − 配对轮 h_am</translation>
  </message>
  <message>
   <source>closed</source>
   <translation>封闭</translation>
  </message>
  <message>
   <source>coast</source>
   <translation>反驱动</translation>
  </message>
  <message>
   <source>common apex: tan θ_a = h_ae/R_e; constant clearance: θ_a = θ_f of the mate</source>
   <translation>共锥顶：tan θ_a = h_ae/R_e；等顶隙：θ_a = 配对轮 θ_f</translation>
  </message>
  <message>
   <source>computing the curvature…</source>
   <translation>正在计算曲率…</translation>
  </message>
  <message>
   <source>concave</source>
   <translation>凹</translation>
  </message>
  <message>
   <source>concave fillet</source>
   <translation>凹侧圆角</translation>
  </message>
  <message>
   <source>concave flank</source>
   <translation>凹齿面</translation>
  </message>
  <message>
   <source>concave meridian</source>
   <translation>凹侧子午线</translation>
  </message>
  <message>
   <source>convex</source>
   <translation>凸</translation>
  </message>
  <message>
   <source>convex fillet</source>
   <translation>凸侧圆角</translation>
  </message>
  <message>
   <source>convex flank</source>
   <translation>凸齿面</translation>
  </message>
  <message>
   <source>convex meridian</source>
   <translation>凸侧子午线</translation>
  </message>
  <message>
   <source>corner</source>
   <translation>角点</translation>
  </message>
  <message>
   <source>count</source>
   <translation>数量</translation>
  </message>
  <message>
   <source>cumulative</source>
   <translation>累积</translation>
  </message>
  <message>
   <source>curvature</source>
   <translation>曲率</translation>
  </message>
  <message>
   <source>cut</source>
   <translation>裁切</translation>
  </message>
  <message>
   <source>cut face</source>
   <translation>剖切面</translation>
  </message>
  <message>
   <source>dedendum</source>
   <translation>齿根高</translation>
  </message>
  <message>
   <source>dedendum angle</source>
   <translation>齿根角</translation>
  </message>
  <message>
   <source>derived</source>
   <translation>推导</translation>
  </message>
  <message>
   <source>deviation</source>
   <translation>偏差</translation>
  </message>
  <message>
   <source>deviation [µm]</source>
   <translation>偏差 [µm]</translation>
  </message>
  <message>
   <source>deviation {factor}</source>
   <translation>偏差 {factor}</translation>
  </message>
  <message>
   <source>deviation {value}</source>
   <translation>偏差 {value}</translation>
  </message>
  <message>
   <source>drive</source>
   <translation>正驱动</translation>
  </message>
  <message>
   <source>ease-off</source>
   <translation>失配量</translation>
  </message>
  <message>
   <source>empty</source>
   <translation>空</translation>
  </message>
  <message>
   <source>en</source>
   <translation>zh</translation>
  </message>
  <message>
   <source>end</source>
   <translation>齿端</translation>
  </message>
  <message>
   <source>even</source>
   <translation>均匀</translation>
  </message>
  <message>
   <source>exact: tangent pitch cones, ρ_lim = r_c0</source>
   <translation>精确：节锥相切，ρ_lim = r_c0</translation>
  </message>
  <message>
   <source>export of {label}</source>
   <translation>导出 {label}</translation>
  </message>
  <message>
   <source>face 0-1</source>
   <translation>齿宽 0-1</translation>
  </message>
  <message>
   <source>face angle</source>
   <translation>面锥角</translation>
  </message>
  <message>
   <source>face cone's apex</source>
   <translation>面锥顶</translation>
  </message>
  <message>
   <source>faces: {count}</source>
   <translation>面：{count}</translation>
  </message>
  <message>
   <source>fillet</source>
   <translation>圆角</translation>
  </message>
  <message>
   <source>first method, mean</source>
   <translation>第一种方法，平均</translation>
  </message>
  <message>
   <source>flank</source>
   <translation>齿面</translation>
  </message>
  <message>
   <source>flanks</source>
   <translation>齿面</translation>
  </message>
  <message>
   <source>flat</source>
   <translation>平坦</translation>
  </message>
  <message>
   <source>frame {n} of {all}</source>
   <translation>第 {n}/{all} 帧</translation>
  </message>
  <message>
   <source>from toe to heel [mm]</source>
   <translation>由小端到大端 [mm]</translation>
  </message>
  <message>
   <source>front face</source>
   <translation>前端面</translation>
  </message>
  <message>
   <source>gap</source>
   <translation>间隙</translation>
  </message>
  <message>
   <source>gap {value} µm</source>
   <translation>间隙 {value} µm</translation>
  </message>
  <message>
   <source>gap µm</source>
   <translation>间隙 µm</translation>
  </message>
  <message>
   <source>gear</source>
   <translation>齿轮</translation>
  </message>
  <message>
   <source>given</source>
   <translation>给定</translation>
  </message>
  <message>
   <source>given for the pinion; x₂ = −x₁</source>
   <translation>小轮给定；x₂ = −x₁</translation>
  </message>
  <message>
   <source>given for the wheel</source>
   <translation>大轮给定</translation>
  </message>
  <message>
   <source>given, or as a part of R_e</source>
   <translation>给定，或为 R_e 的一部分</translation>
  </message>
  <message>
   <source>grid</source>
   <translation>网格</translation>
  </message>
  <message>
   <source>guides</source>
   <translation>引导线</translation>
  </message>
  <message>
   <source>heel</source>
   <translation>大端</translation>
  </message>
  <message>
   <source>hub</source>
   <translation>轮毂</translation>
  </message>
  <message>
   <source>inch</source>
   <translation>英寸</translation>
  </message>
  <message>
   <source>inner cone distance</source>
   <translation>内锥距</translation>
  </message>
  <message>
   <source>inner outside diameter</source>
   <translation>小端外径</translation>
  </message>
  <message>
   <source>inner pitch diameter</source>
   <translation>小端节圆直径</translation>
  </message>
  <message>
   <source>inner spiral angle</source>
   <translation>小端螺旋角</translation>
  </message>
  <message>
   <source>it ended without a reason</source>
   <translation>未说明原因即结束</translation>
  </message>
  <message>
   <source>it took too long</source>
   <translation>用时过长</translation>
  </message>
  <message>
   <source>it was made of another state of the design; changed since: {fields}</source>
   <translation>它由设计的另一状态生成；此后更改：{fields}</translation>
  </message>
  <message>
   <source>kernel</source>
   <translation>内核</translation>
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
   <translation>大轮滞后 [″]</translation>
  </message>
  <message>
   <source>largest</source>
   <translation>最大</translation>
  </message>
  <message>
   <source>largest deviation [µm]</source>
   <translation>最大偏差 [µm]</translation>
  </message>
  <message>
   <source>lb in²</source>
   <translation>lb in²</translation>
  </message>
  <message>
   <source>least</source>
   <translation>至少</translation>
  </message>
  <message>
   <source>left</source>
   <translation>左</translation>
  </message>
  <message>
   <source>left out</source>
   <translation>略去</translation>
  </message>
  <message>
   <source>left-hand pinion</source>
   <translation>小轮左旋</translation>
  </message>
  <message>
   <source>line</source>
   <translation>线</translation>
  </message>
  <message>
   <source>longest bar {length} {unit}</source>
   <translation>最长条 {length} {unit}</translation>
  </message>
  <message>
   <source>max</source>
   <translation>最大</translation>
  </message>
  <message>
   <source>max {largest} · mean {mean}</source>
   <translation>最大 {largest} · 平均 {mean}</translation>
  </message>
  <message>
   <source>mean</source>
   <translation>平均</translation>
  </message>
  <message>
   <source>mean cone distance</source>
   <translation>中锥距</translation>
  </message>
  <message>
   <source>mean normal module</source>
   <translation>中点法向模数</translation>
  </message>
  <message>
   <source>mean pitch diameter</source>
   <translation>中点节圆直径</translation>
  </message>
  <message>
   <source>mean {value} µm</source>
   <translation>平均 {value} µm</translation>
  </message>
  <message>
   <source>member</source>
   <translation>构件</translation>
  </message>
  <message>
   <source>method</source>
   <translation>方法</translation>
  </message>
  <message>
   <source>micro-geometry</source>
   <translation>微观几何</translation>
  </message>
  <message>
   <source>middle of an edge</source>
   <translation>边的中点</translation>
  </message>
  <message>
   <source>mm</source>
   <translation>mm</translation>
  </message>
  <message>
   <source>modifications</source>
   <translation>修形</translation>
  </message>
  <message>
   <source>more than {low}, up to {high}</source>
   <translation>大于 {low}，至多 {high}</translation>
  </message>
  <message>
   <source>most</source>
   <translation>至多</translation>
  </message>
  <message>
   <source>names, colours, product structure</source>
   <translation>名称、颜色、产品结构</translation>
  </message>
  <message>
   <source>never saved</source>
   <translation>从未保存</translation>
  </message>
  <message>
   <source>no</source>
   <translation>否</translation>
  </message>
  <message>
   <source>no curvature to show</source>
   <translation>无曲率可显示</translation>
  </message>
  <message>
   <source>no deviation here</source>
   <translation>此处无偏差</translation>
  </message>
  <message>
   <source>no font with Chinese characters was found, so the report is in English; install one, such as Noto Sans CJK</source>
   <translation>未找到含中文字符的字体，因此报告为英文；请安装一种，例如 Noto Sans CJK</translation>
  </message>
  <message>
   <source>non-uniform</source>
   <translation>非均匀</translation>
  </message>
  <message>
   <source>none</source>
   <translation>无</translation>
  </message>
  <message>
   <source>not built</source>
   <translation>未构建</translation>
  </message>
  <message>
   <source>not computable</source>
   <translation>无法计算</translation>
  </message>
  <message>
   <source>not measured</source>
   <translation>未测量</translation>
  </message>
  <message>
   <source>not reached</source>
   <translation>未达到</translation>
  </message>
  <message>
   <source>not valid: {count} problems</source>
   <translation>无效：{count} 个问题</translation>
  </message>
  <message>
   <source>not valid: {problem}</source>
   <translation>无效：{problem}</translation>
  </message>
  <message>
   <source>nothing</source>
   <translation>无</translation>
  </message>
  <message>
   <source>number</source>
   <translation>数</translation>
  </message>
  <message>
   <source>offset axes</source>
   <translation>偏置轴</translation>
  </message>
  <message>
   <source>one tooth</source>
   <translation>一个齿</translation>
  </message>
  <message>
   <source>optimised</source>
   <translation>优化</translation>
  </message>
  <message>
   <source>outer cone distance</source>
   <translation>外锥距</translation>
  </message>
  <message>
   <source>outer cone distance {distance} mm, face width {width} mm (wheel)</source>
   <translation>外锥距 {distance} mm，齿宽 {width} mm（大轮）</translation>
  </message>
  <message>
   <source>outer module</source>
   <translation>大端模数</translation>
  </message>
  <message>
   <source>outer pitch diameter</source>
   <translation>大端节圆直径</translation>
  </message>
  <message>
   <source>outer spiral angle</source>
   <translation>大端螺旋角</translation>
  </message>
  <message>
   <source>outside diameter</source>
   <translation>外径</translation>
  </message>
  <message>
   <source>oz in²</source>
   <translation>oz in²</translation>
  </message>
  <message>
   <source>pair</source>
   <translation>齿轮副</translation>
  </message>
  <message>
   <source>paper, equation {number}</source>
   <translation>论文，公式 {number}</translation>
  </message>
  <message>
   <source>parameters</source>
   <translation>参数</translation>
  </message>
  <message>
   <source>pinion</source>
   <translation>小轮</translation>
  </message>
  <message>
   <source>pipe along the tooth trace</source>
   <translation>沿齿线的管状扫掠</translation>
  </message>
  <message>
   <source>pitch angle</source>
   <translation>节锥角</translation>
  </message>
  <message>
   <source>pitch error [µm]</source>
   <translation>齿距偏差 [µm]</translation>
  </message>
  <message>
   <source>plane that touches the wheel's face cone</source>
   <translation>与大轮面锥相切的平面</translation>
  </message>
  <message>
   <source>plane that touches the wheel's root cone</source>
   <translation>与大轮根锥相切的平面</translation>
  </message>
  <message>
   <source>point of the 7 × 7 series, toe to heel</source>
   <translation>7 × 7 点列序号，由小端到大端</translation>
  </message>
  <message>
   <source>point_cloud</source>
   <translation>点云</translation>
  </message>
  <message>
   <source>points</source>
   <translation>点</translation>
  </message>
  <message>
   <source>points along each side</source>
   <translation>每边点数</translation>
  </message>
  <message>
   <source>poles</source>
   <translation>控制点</translation>
  </message>
  <message>
   <source>positions</source>
   <translation>位置</translation>
  </message>
  <message>
   <source>process {number}</source>
   <translation>进程 {number}</translation>
  </message>
  <message>
   <source>process {number} on {host}</source>
   <translation>{host} 上的进程 {number}</translation>
  </message>
  <message>
   <source>profile 0-1</source>
   <translation>齿廓 0-1</translation>
  </message>
  <message>
   <source>profile_sweep</source>
   <translation>齿廓扫掠</translation>
  </message>
  <message>
   <source>psi, trace</source>
   <translation>psi，齿线</translation>
  </message>
  <message>
   <source>published</source>
   <translation>论文</translation>
  </message>
  <message>
   <source>record: {name}</source>
   <translation>记录：{name}</translation>
  </message>
  <message>
   <source>right</source>
   <translation>右</translation>
  </message>
  <message>
   <source>right-hand pinion</source>
   <translation>小轮右旋</translation>
  </message>
  <message>
   <source>rim</source>
   <translation>轮缘</translation>
  </message>
  <message>
   <source>rms</source>
   <translation>均方根</translation>
  </message>
  <message>
   <source>roll angle at the pitch cone</source>
   <translation>节锥处滚动角</translation>
  </message>
  <message>
   <source>root</source>
   <translation>齿根</translation>
  </message>
  <message>
   <source>root angle</source>
   <translation>根锥角</translation>
  </message>
  <message>
   <source>root cone's apex</source>
   <translation>根锥顶</translation>
  </message>
  <message>
   <source>rotating_line</source>
   <translation>滚动直线</translation>
  </message>
  <message>
   <source>second method, mean</source>
   <translation>第二种方法，平均</translation>
  </message>
  <message>
   <source>seconds</source>
   <translation>秒</translation>
  </message>
  <message>
   <source>seconds for both flanks</source>
   <translation>两侧齿面用时（秒）</translation>
  </message>
  <message>
   <source>section 3</source>
   <translation>第 3 节</translation>
  </message>
  <message>
   <source>section 4</source>
   <translation>第 4 节</translation>
  </message>
  <message>
   <source>section 5</source>
   <translation>第 5 节</translation>
  </message>
  <message>
   <source>sections</source>
   <translation>截面</translation>
  </message>
  <message>
   <source>series</source>
   <translation>系列</translation>
  </message>
  <message>
   <source>shank</source>
   <translation>轴柄</translation>
  </message>
  <message>
   <source>shift</source>
   <translation>移动</translation>
  </message>
  <message>
   <source>single</source>
   <translation>单个</translation>
  </message>
  <message>
   <source>skin</source>
   <translation>蒙皮</translation>
  </message>
  <message>
   <source>smallest</source>
   <translation>最小</translation>
  </message>
  <message>
   <source>solid of the {member}</source>
   <translation>{member}的实体</translation>
  </message>
  <message>
   <source>solids</source>
   <translation>实体</translation>
  </message>
  <message>
   <source>solids: {count}</source>
   <translation>实体：{count}</translation>
  </message>
  <message>
   <source>spacing</source>
   <translation>间距</translation>
  </message>
  <message>
   <source>square to the pitch cone</source>
   <translation>垂直于节锥</translation>
  </message>
  <message>
   <source>surfaces</source>
   <translation>曲面</translation>
  </message>
  <message>
   <source>surfaces, for older programs</source>
   <translation>曲面，供旧程序使用</translation>
  </message>
  <message>
   <source>sweep</source>
   <translation>扫掠</translation>
  </message>
  <message>
   <source>taking pictures of the views</source>
   <translation>正在拍摄视图</translation>
  </message>
  <message>
   <source>tan β(ρ) = ρ ψ_t′(ρ) at R_e</source>
   <translation>tan β(ρ) = ρ ψ_t′(ρ) 于 R_e</translation>
  </message>
  <message>
   <source>tan β(ρ) = ρ ψ_t′(ρ) at R_i</source>
   <translation>tan β(ρ) = ρ ψ_t′(ρ) 于 R_i</translation>
  </message>
  <message>
   <source>tan β(ρ) = ρ ψ_t′(ρ) at R_m</source>
   <translation>tan β(ρ) = ρ ψ_t′(ρ) 于 R_m</translation>
  </message>
  <message>
   <source>teeth</source>
   <translation>齿</translation>
  </message>
  <message>
   <source>text</source>
   <translation>文本</translation>
  </message>
  <message>
   <source>the CAD kernel's own</source>
   <translation>CAD 内核自身格式</translation>
  </message>
  <message>
   <source>the CAD process died each time it tried</source>
   <translation>CAD 进程每次尝试都中止了</translation>
  </message>
  <message>
   <source>the file is gone</source>
   <translation>文件已不存在</translation>
  </message>
  <message>
   <source>the file is gone; its record is still there</source>
   <translation>文件已不存在；其记录仍在</translation>
  </message>
  <message>
   <source>the file is not as it was written: its checksum is another</source>
   <translation>文件与写出时不同：校验和不符</translation>
  </message>
  <message>
   <source>the mate has no flank here</source>
   <translation>配对轮在此无齿面</translation>
  </message>
  <message>
   <source>the paper's own gear: {low} … {high} µm, means {means} µm</source>
   <translation>论文的齿轮：{low} … {high} µm，平均 {means} µm</translation>
  </message>
  <message>
   <source>the record does not say what was found</source>
   <translation>记录未说明检查结果</translation>
  </message>
  <message>
   <source>the views are not there yet</source>
   <translation>视图尚未就绪</translation>
  </message>
  <message>
   <source>the window shows solids and not the flanks</source>
   <translation>窗口显示的是实体而非齿面</translation>
  </message>
  <message>
   <source>theory, section {number}</source>
   <translation>理论，第 {number} 节</translation>
  </message>
  <message>
   <source>third method, mean</source>
   <translation>第三种方法，平均</translation>
  </message>
  <message>
   <source>this takes more memory than the {limit} MB that the CAD kernel may have; ask for less, or raise the limit in the preferences</source>
   <translation>这需要的内存超过 CAD 内核允许的 {limit} MB；请减少要求，或在首选项中提高上限</translation>
  </message>
  <message>
   <source>tip</source>
   <translation>齿顶</translation>
  </message>
  <message>
   <source>toe</source>
   <translation>小端</translation>
  </message>
  <message>
   <source>tolerance</source>
   <translation>公差</translation>
  </message>
  <message>
   <source>tolerance {value}</source>
   <translation>公差 {value}</translation>
  </message>
  <message>
   <source>tooth</source>
   <translation>齿</translation>
  </message>
  <message>
   <source>triangles alone</source>
   <translation>仅三角形</translation>
  </message>
  <message>
   <source>triangles in colour, for viewers</source>
   <translation>彩色三角形，供查看器使用</translation>
  </message>
  <message>
   <source>triangles within {um} µm of theory ({limit} µm allowed)</source>
   <translation>三角形距理论 {um} µm 以内（允许 {limit} µm）</translation>
  </message>
  <message>
   <source>triangles, for printing</source>
   <translation>三角形，用于打印</translation>
  </message>
  <message>
   <source>turn</source>
   <translation>转动</translation>
  </message>
  <message>
   <source>turn of contact over the face at half the depth, over the pitch</source>
   <translation>齿高一半处沿齿宽接触的转角与齿距之比</translation>
  </message>
  <message>
   <source>turn of contact over the profile in the middle of the face, over the pitch</source>
   <translation>齿宽中部沿齿廓接触的转角与齿距之比</translation>
  </message>
  <message>
   <source>turn of contact over the whole flank, over the pitch</source>
   <translation>整个齿面接触的转角与齿距之比</translation>
  </message>
  <message>
   <source>turn of the pinion [°]</source>
   <translation>小轮转角 [°]</translation>
  </message>
  <message>
   <source>updating…</source>
   <translation>更新中…</translation>
  </message>
  <message>
   <source>updating… (max was {largest})</source>
   <translation>更新中…（最大曾为 {largest}）</translation>
  </message>
  <message>
   <source>valid</source>
   <translation>有效</translation>
  </message>
  <message>
   <source>waiting for the CAD kernel</source>
   <translation>等待 CAD 内核</translation>
  </message>
  <message>
   <source>waiting for the CAD kernel…</source>
   <translation>等待 CAD 内核…</translation>
  </message>
  <message>
   <source>waiting for the CAD process</source>
   <translation>等待 CAD 进程</translation>
  </message>
  <message>
   <source>waiting…</source>
   <translation>等待…</translation>
  </message>
  <message>
   <source>wheel</source>
   <translation>大轮</translation>
  </message>
  <message>
   <source>whole gear</source>
   <translation>整个齿轮</translation>
  </message>
  <message>
   <source>with the backlash's share</source>
   <translation>计入侧隙份额</translation>
  </message>
  <message>
   <source>within</source>
   <translation>合格</translation>
  </message>
  <message>
   <source>writing…</source>
   <translation>写出中…</translation>
  </message>
  <message>
   <source>yes</source>
   <translation>是</translation>
  </message>
  <message>
   <source>{count} changed</source>
   <translation>{count} 项已改</translation>
  </message>
  <message>
   <source>{count} constructions failed. </source>
   <translation>{count} 次构建失败。</translation>
  </message>
  <message>
   <source>{count} entries, {bad} warnings or errors</source>
   <translation>{count} 条，其中 {bad} 条警告或错误</translation>
  </message>
  <message>
   <source>{count} of {all}</source>
   <translation>{count} / {all}</translation>
  </message>
  <message>
   <source>{count} of {all} values differ; the difference is other minus this.</source>
   <translation>{all} 个值中有 {count} 个不同；差值为另一设计减本设计。</translation>
  </message>
  <message>
   <source>{count} pages, {size:.1f} MB</source>
   <translation>{count} 页，{size:.1f} MB</translation>
  </message>
  <message>
   <source>{count} problems</source>
   <translation>{count} 个问题</translation>
  </message>
  <message>
   <source>{count} steps</source>
   <translation>{count} 级</translation>
  </message>
  <message>
   <source>{count} warnings</source>
   <translation>{count} 个警告</translation>
  </message>
  <message>
   <source>{count}: the last good model stays</source>
   <translation>{count}：保留最后的有效模型</translation>
  </message>
  <message>
   <source>{curve}, spiral angle {spiral}° ({place}), pressure angle {pressure}° ({kind})</source>
   <translation>{curve}，螺旋角 {spiral}°（{place}），压力角 {pressure}°（{kind}）</translation>
  </message>
  <message>
   <source>{direction}, {size}″ peak to peak</source>
   <translation>{direction}，峰峰值 {size}″</translation>
  </message>
  <message>
   <source>{direction}: ease-off and lines of contact</source>
   <translation>{direction}：ease-off 与接触线</translation>
  </message>
  <message>
   <source>{faces} faces · flanks within {largest} · built in {took}</source>
   <translation>{faces} 个面 · 齿面偏差 {largest} 以内 · 用时 {took}</translation>
  </message>
  <message>
   <source>{face}, tooth {number}</source>
   <translation>{face}，第 {number} 齿</translation>
  </message>
  <message>
   <source>{fields} and {count} more</source>
   <translation>{fields} 等另外 {count} 项</translation>
  </message>
  <message>
   <source>{file}, against the {member}</source>
   <translation>{file}，对比{member}</translation>
  </message>
  <message>
   <source>{file}, against the {member}.</source>
   <translation>{file}，与{member}比较。</translation>
  </message>
  <message>
   <source>{file}, against the {member}: points of {flanks} flank faces of {faces}</source>
   <translation>{file}，对比{member}：取自 {faces} 个面中的 {flanks} 个齿面</translation>
  </message>
  <message>
   <source>{file}, against the {member}: points of {flanks} flank faces of {faces}.</source>
   <translation>{file}，与{member}比较：取自 {faces} 个面中 {flanks} 个齿面的点。</translation>
  </message>
  <message>
   <source>{flank}, {member}: signed deviation, plus is metal added; each map has a scale of its own.</source>
   <translation>{member}{flank}：带符号偏差，正值表示多出材料；各图标尺各自独立。</translation>
  </message>
  <message>
   <source>{keys} belongs to “{command}”, which would lose it.</source>
   <translation>{keys} 属于“{command}”，将被其失去。</translation>
  </message>
  <message>
   <source>{low} to {high}</source>
   <translation>{low} 至 {high}</translation>
  </message>
  <message>
   <source>{member} {face}: within {largest} µm of theory ({limit} µm allowed)</source>
   <translation>{member} {face}：距理论 {largest} µm 以内（允许 {limit} µm）</translation>
  </message>
  <message>
   <source>{member}, {face}, tooth {number}</source>
   <translation>{member}，{face}，第 {number} 齿</translation>
  </message>
  <message>
   <source>{member}, {flank} flank</source>
   <translation>{member}，{flank}齿面</translation>
  </message>
  <message>
   <source>{member}, {flank} flank: all points of the deviation map</source>
   <translation>{member}，{flank}齿面：偏差云图的所有点</translation>
  </message>
  <message>
   <source>{member}, {method}: 5 × 9 points, plus is upwards.</source>
   <translation>{member}，{method}：5 × 9 点，正值向上。</translation>
  </message>
  <message>
   <source>{member}: Gaussian curvature, theory and the optimised surfaces on one scale.</source>
   <translation>{member}：高斯曲率，理论与优化曲面同一标尺。</translation>
  </message>
  <message>
   <source>{member}: deviation at 7 × 7 points of each flank; dotted: the means that the paper states.</source>
   <translation>{member}：每侧齿面 7 × 7 点处的偏差；点线：论文给出的平均值。</translation>
  </message>
  <message>
   <source>{member}: largest deviation over both flanks against the effort.</source>
   <translation>{member}：两侧齿面的最大偏差与工作量的关系。</translation>
  </message>
  <message>
   <source>{member}: measured deviation, mean of all teeth; a bar upwards and red is metal added.</source>
   <translation>{member}：实测偏差，各齿平均；条向上及红色表示多出材料。</translation>
  </message>
  <message>
   <source>{member}: no blank yet</source>
   <translation>{member}：尚无轮坯</translation>
  </message>
  <message>
   <source>{member}: pitch errors of the teeth that were measured.</source>
   <translation>{member}：已测轮齿的齿距偏差。</translation>
  </message>
  <message>
   <source>{method}: modifications left out</source>
   <translation>{method}：略去修形</translation>
  </message>
  <message>
   <source>{method}: the nearest flank that a rigid line sweeps</source>
   <translation>{method}：刚性直线扫出的最近齿面</translation>
  </message>
  <message>
   <source>{moment} by {program}, {kernel}</source>
   <translation>{moment}，{program}，{kernel}</translation>
  </message>
  <message>
   <source>{name} (missing)</source>
   <translation>{name}（缺失）</translation>
  </message>
  <message>
   <source>{name} (read-only)</source>
   <translation>{name}（只读）</translation>
  </message>
  <message>
   <source>{name} is no longer on the disk; Save writes it again.</source>
   <translation>{name} 已不在磁盘上；保存可重新写出。</translation>
  </message>
  <message>
   <source>{name} was not opened: it has {count} problems, the first at {problem}</source>
   <translation>{name} 未打开：有 {count} 个问题，首个为 {problem}</translation>
  </message>
  <message>
   <source>{name} was not opened: {problem}</source>
   <translation>{name} 未打开：{problem}</translation>
  </message>
  <message>
   <source>{name} was not saved: it is open in another GearStudio window ({holder})</source>
   <translation>{name} 未保存：已在另一 GearStudio 窗口打开（{holder}）</translation>
  </message>
  <message>
   <source>{name} was not saved: {problem}</source>
   <translation>{name} 未保存：{problem}</translation>
  </message>
  <message>
   <source>{name}, cumulative</source>
   <translation>{name}，累积</translation>
  </message>
  <message>
   <source>{name}, single</source>
   <translation>{name}，单个</translation>
  </message>
  <message>
   <source>{number} of {count}</source>
   <translation>{number} / {count}</translation>
  </message>
  <message>
   <source>{passed} of {all} published values agree to the last printed digit</source>
   <translation>{all} 个已发表值中 {passed} 个与最后一位印刷数字一致</translation>
  </message>
  <message>
   <source>{pinion} / {wheel} teeth, outer module {module} mm, shaft angle {angle}°, {hand}</source>
   <translation>{pinion} / {wheel} 齿，大端模数 {module} mm，轴交角 {angle}°，{hand}</translation>
  </message>
  <message>
   <source>{quantity}, {flank}</source>
   <translation>{quantity}，{flank}</translation>
  </message>
  <message>
   <source>{size} µm for the optimised variants</source>
   <translation>优化变体 {size} µm</translation>
  </message>
  <message>
   <source>{summary} ({section} of the paper)</source>
   <translation>{summary}（论文{section}）</translation>
  </message>
  <message>
   <source>{text} ({done} of {all})</source>
   <translation>{text}（{done}/{all}）</translation>
  </message>
  <message>
   <source>{title} [{unit}]
Drag an end of the bar to change the range, double-click to type it. Grey: no value there</source>
   <translation>{title} [{unit}]
拖动两端改变范围，双击键入。灰色：无值</translation>
  </message>
  <message>
   <source>{title} curvature [{unit}]</source>
   <translation>{title}曲率 [{unit}]</translation>
  </message>
  <message>
   <source>{title} curvature less theory [{unit}]</source>
   <translation>{title}曲率减理论 [{unit}]</translation>
  </message>
  <message>
   <source>{title}: a number from {low} to {high} {unit}, or nothing</source>
   <translation>{title}：{low} 至 {high} {unit} 之间的数，或留空</translation>
  </message>
  <message>
   <source>{title}[*] – GearStudio</source>
   <translation>{title}[*] – GearStudio</translation>
  </message>
  <message>
   <source>{view}: {problem}</source>
   <translation>{view}：{problem}</translation>
  </message>
  <message>
   <source>{words}; {failed} do not.</source>
   <translation>{words}；{failed} 个不一致。</translation>
  </message>
  <message>
   <source>{w} × {h} pixels</source>
   <translation>{w} × {h} 像素</translation>
  </message>
  <message>
   <source>×1, as it is</source>
   <translation>×1，原样</translation>
  </message>
  <message>
   <source>Σ  shaft angle</source>
   <translation>Σ  轴交角</translation>
  </message>
  <message>
   <source>γ + γ_mate − arccos(cos δ_a/cos δ_b) of the mate</source>
   <translation>γ + γ_mate − 配对轮 arccos(cos δ_a/cos δ_b)</translation>
  </message>
  <message>
   <source>“{command}”: usual keys {keys}</source>
   <translation>“{command}”：默认快捷键 {keys}</translation>
  </message>
  <message>
   <source>“{name}” is not known here</source>
   <translation>此处不认识“{name}”</translation>
  </message>
  <message>
   <source>“{name}” is open in another GearStudio window ({holder}).</source>
   <translation>“{name}”已在另一 GearStudio 窗口打开（{holder}）。</translation>
  </message>
  <message>
   <source>“{name}” was changed by another program.</source>
   <translation>“{name}”已被其他程序更改。</translation>
  </message>
  <message>
   <source>“{text}” is neither a number nor a sum</source>
   <translation>“{text}”既非数也非算式</translation>
  </message>
  <message>
   <source>“{unit}” does not suit this field</source>
   <translation>“{unit}”不适用于此字段</translation>
  </message>
  <message>
   <source>✓ pass</source>
   <translation>✓ 通过</translation>
  </message>
  <message>
   <source>✗ fail</source>
   <translation>✗ 不符</translation>
  </message>
 </context>
 <context>
  <name>Sentences</name>
  <message>
   <source>"toe" is defined for the Archimedean curve only, and the curve is "{0}"; use "mean", or the curve "archimedean"</source>
   <translation>"toe" 仅适用于阿基米德曲线，而当前曲线为 "{0}"；请用 "mean"，或曲线 "archimedean"</translation>
  </message>
  <message>
   <source>, where {0} mm could be a measured deviation</source>
   <translation>，而测量偏差至多 {0} mm</translation>
  </message>
  <message>
   <source>; use an offset of 0 mm</source>
   <translation>；请取偏置 0 mm</translation>
  </message>
  <message>
   <source>; use {0} mm or nearer to 0</source>
   <translation>；请取 {0} mm 或更接近 0</translation>
  </message>
  <message>
   <source>Addendum angle</source>
   <translation>齿顶角</translation>
  </message>
  <message>
   <source>Clearance over depth</source>
   <translation>顶隙与齿高之比</translation>
  </message>
  <message>
   <source>Dedendum angle</source>
   <translation>齿根角</translation>
  </message>
  <message>
   <source>Depth factor</source>
   <translation>齿高系数</translation>
  </message>
  <message>
   <source>Depth system</source>
   <translation>齿高制</translation>
  </message>
  <message>
   <source>From the wheel's pitch cone to its face cone; leave empty to take the taper's.</source>
   <translation>大轮节锥到面锥；留空则按收缩方式。</translation>
  </message>
  <message>
   <source>From the wheel's root cone to its pitch cone; leave empty to take the taper's.</source>
   <translation>大轮根锥到节锥；留空则按收缩方式。</translation>
  </message>
  <message>
   <source>Mean addendum factor</source>
   <translation>中点齿顶高系数</translation>
  </message>
  <message>
   <source>Outer module: the factors of the tooth, over the outer module at the heel. ISO 23509: factors of the mean normal module at the mean point, with a taper.</source>
   <translation>大端模数：以大端模数计的齿系数。ISO 23509：以中点法向模数计的系数，带收缩方式。</translation>
  </message>
  <message>
   <source>Standard: root lines through the pitch apex. Uniform: the same depth from toe to heel. Duplex: constant slot width. Tilted root: constant slot width, but not steeper than 1.3 times standard.</source>
   <translation>标准：齿根线过节锥顶。等高：小端到大端齿高相同。双重：槽宽不变。倾斜齿根：槽宽不变，但不陡于标准的 1.3 倍。</translation>
  </message>
  <message>
   <source>The wheel's mean addendum over working depth; leave empty for 0.21 + 0.29/u₉₀².</source>
   <translation>大轮中点齿顶高与工作齿高之比；留空为 0.21 + 0.29/u₉₀²。</translation>
  </message>
  <message>
   <source>Thickness factor</source>
   <translation>齿厚系数</translation>
  </message>
  <message>
   <source>Thickness that the pinion's teeth gain over the wheel's, over mean normal module.</source>
   <translation>小轮齿比大轮齿多出的厚度与中点法向模数之比。</translation>
  </message>
  <message>
   <source>Tip clearance over working depth.</source>
   <translation>顶隙与工作齿高之比。</translation>
  </message>
  <message>
   <source>Working depth at the mean point over mean normal module.</source>
   <translation>中点工作齿高与中点法向模数之比。</translation>
  </message>
  <message>
   <source>a back face {0} mm from the apex cuts into the roots at the heel; use at least {1} mm</source>
   <translation>背面距锥顶 {0} mm，切入大端齿根；请取至少 {1} mm</translation>
  </message>
  <message>
   <source>a bore of {0} mm leaves no wall under the roots; use at most {1} mm</source>
   <translation>孔径 {0} mm 使齿根下无壁厚；请取至多 {1} mm</translation>
  </message>
  <message>
   <source>a chamfer at the end of the teeth cuts a face more than once</source>
   <translation>端部倒角多次切到同一面</translation>
  </message>
  <message>
   <source>a chamfer at the end of the teeth does not cut off their tips alone</source>
   <translation>端部倒角不只切去齿顶</translation>
  </message>
  <message>
   <source>a chamfer of {0} mm is too small to be modelled; use 0 for none, or at least {1} mm</source>
   <translation>倒角 {0} mm 太小无法建模；请取 0（无）或至少 {1} mm</translation>
  </message>
  <message>
   <source>a chamfer of {0} mm leaves no tip between toe and heel or reaches the roots; use at most {1} mm</source>
   <translation>倒角 {0} mm 使大小端之间无齿顶或触及齿根；请取至多 {1} mm</translation>
  </message>
  <message>
   <source>a chart is saved as {0}, not as {1}</source>
   <translation>图表可存为 {0}，不能存为 {1}</translation>
  </message>
  <message>
   <source>a constant slot width would taper the depth by {0}°, beyond {1}°; use {2}</source>
   <translation>槽宽不变会使齿高收缩 {0}°，超过 {1}°；请用{2}</translation>
  </message>
  <message>
   <source>a coordinate of the measured points is not a number</source>
   <translation>某测点坐标不是数</translation>
  </message>
  <message>
   <source>a cutter of radius {0} mm does not cross the wheel's whole face width; {1}</source>
   <translation>刀盘半径 {0} mm 不能横跨大轮全齿宽；{1}</translation>
  </message>
  <message>
   <source>a cutter of radius {0} mm does not cross the whole face width</source>
   <translation>刀盘半径 {0} mm 不能横跨全齿宽</translation>
  </message>
  <message>
   <source>a cutter radius of {0} mm</source>
   <translation>刀盘半径 {0} mm</translation>
  </message>
  <message>
   <source>a document (PDF)</source>
   <translation>文档（PDF）</translation>
  </message>
  <message>
   <source>a face is missing or not valid</source>
   <translation>某个面缺失或无效</translation>
  </message>
  <message>
   <source>a face width of {0} mm does not fit a wheel of {1} mm; use less than {2} mm</source>
   <translation>齿宽 {0} mm 不适合 {1} mm 的大轮；请取小于 {2} mm</translation>
  </message>
  <message>
   <source>a fillet of {0} mm on the {1} reaches into the {2} flank that meets the wheel's tip</source>
   <translation>{1}上 {0} mm 的圆角伸入与大轮齿顶啮合的{2}齿面</translation>
  </message>
  <message>
   <source>a grid of {0} x {1} points has no area; use 2 or more each way</source>
   <translation>{0} x {1} 点的网格没有面积；每方向至少取 2</translation>
  </message>
  <message>
   <source>a grid of {0} x {1} points is too coarse for a contact analysis; use 3 or more</source>
   <translation>{0} x {1} 点的网格对接触分析太粗；至少取 3</translation>
  </message>
  <message>
   <source>a hub of {0} mm must lie between the bore and the rim; use more than {1} and less than {2} mm</source>
   <translation>轮毂 {0} mm 必须在内孔与轮缘之间；请取大于 {1} 且小于 {2} mm</translation>
  </message>
  <message>
   <source>a hub {0} mm long reaches beyond the toe; use at most {1} mm</source>
   <translation>轮毂长 {0} mm 超出小端；请取至多 {1} mm</translation>
  </message>
  <message>
   <source>a larger pressure angle or more teeth</source>
   <translation>较大的压力角或更多齿数</translation>
  </message>
  <message>
   <source>a marking compound {0} µm thick leaves no mark; use more than 0</source>
   <translation>涂料厚 {0} µm 不留痕迹；请取大于 0</translation>
  </message>
  <message>
   <source>a misalignment and the thickness of the marking compound must be finite numbers</source>
   <translation>安装误差和涂料厚度必须是有限数</translation>
  </message>
  <message>
   <source>a model (GLB)</source>
   <translation>模型（GLB）</translation>
  </message>
  <message>
   <source>a model (STEP)</source>
   <translation>模型（STEP）</translation>
  </message>
  <message>
   <source>a model (STL)</source>
   <translation>模型（STL）</translation>
  </message>
  <message>
   <source>a narrower face width</source>
   <translation>较窄的齿宽</translation>
  </message>
  <message>
   <source>a number in it has thousands of digits</source>
   <translation>其中有一个数有几千位</translation>
  </message>
  <message>
   <source>a number needs digits on both sides of its point; write “{0} = {1}”</source>
   <translation>小数点两边都要有数字；请写 “{0} = {1}”</translation>
  </message>
  <message>
   <source>a number stands without a unit, which is always the same; write “{0} = {1}”</source>
   <translation>数字后面不写单位，单位始终不变；请写 “{0} = {1}”</translation>
  </message>
  <message>
   <source>a part of the path is a file, not a folder</source>
   <translation>路径的一部分是文件而非文件夹</translation>
  </message>
  <message>
   <source>a picture (GIF)</source>
   <translation>图片（GIF）</translation>
  </message>
  <message>
   <source>a picture (JPEG)</source>
   <translation>图片（JPEG）</translation>
  </message>
  <message>
   <source>a picture (PNG)</source>
   <translation>图片（PNG）</translation>
  </message>
  <message>
   <source>a picture needs a name that ends in {0}</source>
   <translation>图片名须以 {0} 结尾</translation>
  </message>
  <message>
   <source>a pressure angle of {0}°</source>
   <translation>压力角 {0}°</translation>
  </message>
  <message>
   <source>a profile shift of {0}</source>
   <translation>变位系数 {0}</translation>
  </message>
  <message>
   <source>a shaft angle of {0}° makes the wheel's pitch cone {1}°; it must stay below {2}°: use at most {3}°</source>
   <translation>轴交角 {0}° 使大轮节锥角为 {1}°；必须小于 {2}°：请取至多 {3}°</translation>
  </message>
  <message>
   <source>a shank of {0} mm is wider than the back face; use at most {1} mm</source>
   <translation>轴径 {0} mm 大于背面；请取至多 {1} mm</translation>
  </message>
  <message>
   <source>a smaller addendum factor, profile shift or pressure angle</source>
   <translation>较小的齿顶高系数、变位或压力角</translation>
  </message>
  <message>
   <source>a smaller fillet factor</source>
   <translation>较小的齿根圆角系数</translation>
  </message>
  <message>
   <source>a smaller fillet factor or deeper teeth</source>
   <translation>较小的齿根圆角系数或较高的齿</translation>
  </message>
  <message>
   <source>a smaller one</source>
   <translation>较小的值</translation>
  </message>
  <message>
   <source>a smaller profile shift and backlash</source>
   <translation>较小的变位和侧隙</translation>
  </message>
  <message>
   <source>a smaller profile shift or pressure angle</source>
   <translation>较小的变位或压力角</translation>
  </message>
  <message>
   <source>a spiral angle of {0}°</source>
   <translation>螺旋角 {0}°</translation>
  </message>
  <message>
   <source>a spiral angle of {0}° on the {1} with an offset of {2} mm turns the {3}'s teeth against their hand, to {4}°; {5} or an offset of the other sign</source>
   <translation>{1}螺旋角 {0}°、偏置 {2} mm 会使{3}的齿反向，达 {4}°；{5}或取反号偏置</translation>
  </message>
  <message>
   <source>a text needs two straight quotation marks on one line</source>
   <translation>文本需要在同一行内用两个直引号括起来</translation>
  </message>
  <message>
   <source>a value of type {0}</source>
   <translation>类型为 {0} 的值</translation>
  </message>
  <message>
   <source>a whole number of more than 40 digits</source>
   <translation>超过 40 位的整数</translation>
  </message>
  <message>
   <source>a word needs straight quotation marks; write “{0} = "{1}"”</source>
   <translation>单词需要直引号；请写 “{0} = "{1}"”</translation>
  </message>
  <message>
   <source>a {0} flank reaches into the root; the variant is too inaccurate for this design to make a tooth of</source>
   <translation>{0}齿面伸入齿根；该方案对此设计过于不精确，无法成齿</translation>
  </message>
  <message>
   <source>addendum and dedendum angles of {0} leave {1} of the mean depth at an end of the face, less than {2}; use smaller ones, the standard taper or a smaller face width</source>
   <translation>齿顶角和齿根角 {0} 使齿宽一端仅余中点齿高的 {1}，小于 {2}；请用较小的角、标准收缩或较窄齿宽</translation>
  </message>
  <message>
   <source>an archive (ZIP), as 3MF models and office documents are</source>
   <translation>压缩包（ZIP），3MF 模型和办公文档也是这种文件</translation>
  </message>
  <message>
   <source>an offset of {0} mm admits no pitch cones for these teeth, spiral angle and cutter</source>
   <translation>偏置 {0} mm 对此齿数、螺旋角和刀盘无法得到节锥</translation>
  </message>
  <message>
   <source>an offset of {0} mm leaves the pinion no face and root cone</source>
   <translation>偏置 {0} mm 使小轮没有面锥和根锥</translation>
  </message>
  <message>
   <source>another program is using it</source>
   <translation>另一个程序正在使用它</translation>
  </message>
  <message>
   <source>another tooth depth or more teeth</source>
   <translation>其他齿高或更多齿数</translation>
  </message>
  <message>
   <source>ask who owns it to let you read it</source>
   <translation>请向文件所有者申请读取权限</translation>
  </message>
  <message>
   <source>base angle {0} rad is outside (0, pi/2)</source>
   <translation>基锥角 {0} rad 超出 (0, pi/2)</translation>
  </message>
  <message>
   <source>best fit</source>
   <translation>最佳拟合</translation>
  </message>
  <message>
   <source>body {0}</source>
   <translation>轮体 {0}</translation>
  </message>
  <message>
   <source>building</source>
   <translation>正在构建</translation>
  </message>
  <message>
   <source>building {0}, {1}, {2}</source>
   <translation>正在构建{0}，{1}，{2}</translation>
  </message>
  <message>
   <source>check its name, it may have been moved</source>
   <translation>请检查名称，文件可能已被移动</translation>
  </message>
  <message>
   <source>checking</source>
   <translation>正在检查</translation>
  </message>
  <message>
   <source>choose a file in it</source>
   <translation>请选择其中的文件</translation>
  </message>
  <message>
   <source>choose a file that GearStudio saved, NAME.gear.toml</source>
   <translation>请选择由 GearStudio 保存的文件（NAME.gear.toml）</translation>
  </message>
  <message>
   <source>choose a shorter one</source>
   <translation>请使用更短的名称</translation>
  </message>
  <message>
   <source>choose another disk</source>
   <translation>请选择另一个磁盘</translation>
  </message>
  <message>
   <source>choose another disk, and have this one checked</source>
   <translation>请选择另一个磁盘，并检查这个磁盘</translation>
  </message>
  <message>
   <source>choose another folder</source>
   <translation>请选择另一个文件夹</translation>
  </message>
  <message>
   <source>choose another folder, or ask who owns this one</source>
   <translation>请选择另一个文件夹，或询问此文件夹的所有者</translation>
  </message>
  <message>
   <source>choose another folder, or make this one first</source>
   <translation>请选择另一个文件夹，或先创建此文件夹</translation>
  </message>
  <message>
   <source>choose another name</source>
   <translation>请使用另一个名称</translation>
  </message>
  <message>
   <source>choosing faces</source>
   <translation>正在选择面</translation>
  </message>
  <message>
   <source>close it there and try again</source>
   <translation>请在那里关闭后再试</translation>
  </message>
  <message>
   <source>closed valid </source>
   <translation>封闭有效</translation>
  </message>
  <message>
   <source>collecting the gear</source>
   <translation>正在汇集齿轮</translation>
  </message>
  <message>
   <source>contact on the {0}'s {1} flank starts below its root cone</source>
   <translation>{0}{1}齿面的接触始于其根锥以下</translation>
  </message>
  <message>
   <source>continuing the flanks</source>
   <translation>正在延伸齿面</translation>
  </message>
  <message>
   <source>convergence</source>
   <translation>收敛</translation>
  </message>
  <message>
   <source>copy the file from another place, and have this disk checked</source>
   <translation>请从其他地方复制该文件，并检查此磁盘</translation>
  </message>
  <message>
   <source>cutting of the {0}</source>
   <translation>{0}的切削</translation>
  </message>
  <message>
   <source>cutting the tooth spaces left {0} solids instead of one</source>
   <translation>切齿槽后得到 {0} 个实体而非一个</translation>
  </message>
  <message>
   <source>cutting tooth spaces {0} to {1} of {2}</source>
   <translation>正在切第 {0} 至 {1} 个齿槽，共 {2} 个</translation>
  </message>
  <message>
   <source>does not reach everywhere: {0}</source>
   <translation>未到达各处：{0}</translation>
  </message>
  <message>
   <source>drawing {0}</source>
   <translation>正在绘制{0}</translation>
  </message>
  <message>
   <source>face angle {0}° and root angle {1}° of the wheel must lie between 0° and 90°; use smaller addendum and dedendum angles or the uniform taper</source>
   <translation>大轮面锥角 {0}° 和根锥角 {1}° 必须在 0° 与 90° 之间；请用较小的齿顶角和齿根角或等高齿</translation>
  </message>
  <message>
   <source>face {0} is not valid after reading back</source>
   <translation>回读后面 {0} 无效</translation>
  </message>
  <message>
   <source>films are written as .mp4 or .gif</source>
   <translation>影片以 .mp4 或 .gif 写出</translation>
  </message>
  <message>
   <source>free some space, or choose another disk</source>
   <translation>请腾出空间，或选择另一个磁盘</translation>
  </message>
  <message>
   <source>geometry data sheet</source>
   <translation>几何数据表</translation>
  </message>
  <message>
   <source>give the pair deeper teeth or a larger overlap</source>
   <translation>请增加齿高或重合度</translation>
  </message>
  <message>
   <source>has nothing to mesh with at an end, where the wheel's tips lie inside its base cone</source>
   <translation>在一端无可啮合，因大轮齿顶位于其基锥内</translation>
  </message>
  <message>
   <source>heel chamfer</source>
   <translation>大端倒角</translation>
  </message>
  <message>
   <source>heel end</source>
   <translation>大端端面</translation>
  </message>
  <message>
   <source>instead of {0} µm at most</source>
   <translation>而非至多 {0} µm</translation>
  </message>
  <message>
   <source>internal error: {0}</source>
   <translation>内部错误：{0}</translation>
  </message>
  <message>
   <source>is a folder</source>
   <translation>是文件夹</translation>
  </message>
  <message>
   <source>is undercut near the {0}, {1} mm from the pitch apex, polar angle {2}° (area ratio {3}, must exceed {4})</source>
   <translation>在{0}附近根切，距节锥顶 {1} mm，极角 {2}°（面积比 {3}，须大于 {4}）</translation>
  </message>
  <message>
   <source>it cannot be read from line {0} on; compare it with a design that GearStudio saved</source>
   <translation>从第 {0} 行起无法读取；请与 GearStudio 保存的设计比较</translation>
  </message>
  <message>
   <source>it cannot be read to its end; compare it with a design that GearStudio saved</source>
   <translation>无法读到文件末尾；请与 GearStudio 保存的设计比较</translation>
  </message>
  <message>
   <source>it ended with exit status {0}</source>
   <translation>它以状态 {0} 结束</translation>
  </message>
  <message>
   <source>it failed to start {0} times; {1}</source>
   <translation>启动失败 {0} 次；{1}</translation>
  </message>
  <message>
   <source>it holds something that is not a number</source>
   <translation>其中含有非数值</translation>
  </message>
  <message>
   <source>it is a model of another gear, or its axis is not the z axis</source>
   <translation>这是另一齿轮的模型，或其轴不是 z 轴</translation>
  </message>
  <message>
   <source>it stopped answering</source>
   <translation>它不再响应</translation>
  </message>
  <message>
   <source>it was killed by {0}</source>
   <translation>它被 {0} 终止</translation>
  </message>
  <message>
   <source>it was made of another state of the design: {0} changed since</source>
   <translation>由设计的另一状态生成：此后 {0} 已更改</translation>
  </message>
  <message>
   <source>its result could not be read: {0}</source>
   <translation>无法读取其结果：{0}</translation>
  </message>
  <message>
   <source>joining the faces</source>
   <translation>正在拼接各面</translation>
  </message>
  <message>
   <source>leaves the tip of its teeth {0} mm wide at the heel, less than {1} mm: they are pointed</source>
   <translation>使大端齿顶仅宽 {0} mm，小于 {1} mm：齿变尖</translation>
  </message>
  <message>
   <source>leaves the {0} no tooth space at the foot of the flanks</source>
   <translation>使{0}齿面根部没有齿槽</translation>
  </message>
  <message>
   <source>leaves {0} mm of the tooth space at the foot of the flanks, less than {1} mm</source>
   <translation>使齿面根部齿槽仅余 {0} mm，小于 {1} mm</translation>
  </message>
  <message>
   <source>left out</source>
   <translation>略去</translation>
  </message>
  <message>
   <source>less than {0}</source>
   <translation>小于 {0}</translation>
  </message>
  <message>
   <source>lies {0} µm from theory instead of at most {1} µm</source>
   <translation>距理论 {0} µm，而非至多 {1} µm</translation>
  </message>
  <message>
   <source>line {0} has {1} columns, where {2} or more are needed</source>
   <translation>第 {0} 行有 {1} 列，至少需要 {2} 列</translation>
  </message>
  <message>
   <source>line {0} has {1} column{2}; give x, y, z or x, y, z, nx, ny, nz, or name the columns in a header line</source>
   <translation>第 {0} 行有 {1} 列；请给出 x, y, z 或 x, y, z, nx, ny, nz，或在标题行中命名各列</translation>
  </message>
  <message>
   <source>line {0} is not UTF-8 text; save the file as UTF-8 in your editor</source>
   <translation>第 {0} 行不是 UTF-8 文本；请在编辑器中将文件另存为 UTF-8</translation>
  </message>
  <message>
   <source>line {0}, “{1}”: {2}</source>
   <translation>第 {0} 行 “{1}”：{2}</translation>
  </message>
  <message>
   <source>line {0}: {1} is not a finite number</source>
   <translation>第 {0} 行：{1} 不是有限数</translation>
  </message>
  <message>
   <source>line {0}: {1} is not a number</source>
   <translation>第 {0} 行：{1} 不是数</translation>
  </message>
  <message>
   <source>lower side</source>
   <translation>下侧</translation>
  </message>
  <message>
   <source>makes its micro-geometry rise by up to {0} µm per mm of the flank, more than {1}</source>
   <translation>使微观几何每 mm 齿面最多上升 {0} µm，超过 {1}</translation>
  </message>
  <message>
   <source>makes the {0}'s teeth pointed</source>
   <translation>使{0}的齿变尖</translation>
  </message>
  <message>
   <source>measuring the gaps</source>
   <translation>正在测量间隙</translation>
  </message>
  <message>
   <source>meets the wheel inside its base cone with its tips</source>
   <translation>其齿顶在大轮基锥内与其相遇</translation>
  </message>
  <message>
   <source>meshing of the {0}</source>
   <translation>{0}的网格化</translation>
  </message>
  <message>
   <source>more pinion teeth, a larger spiral angle or shallower teeth</source>
   <translation>更多小轮齿数、较大螺旋角或较矮的齿</translation>
  </message>
  <message>
   <source>more teeth</source>
   <translation>更多齿数</translation>
  </message>
  <message>
   <source>more than {0}</source>
   <translation>大于 {0}</translation>
  </message>
  <message>
   <source>more than {0}, up to {1}</source>
   <translation>大于 {0}，至多 {1}</translation>
  </message>
  <message>
   <source>no construction {0}; use {1}</source>
   <translation>没有构造 {0}；请用 {1}</translation>
  </message>
  <message>
   <source>no contact: at some turn no tooth of the pinion faces a flank of the wheel; {0}</source>
   <translation>无接触：某转角处小轮无齿面对大轮齿面；{0}</translation>
  </message>
  <message>
   <source>no fillet of {0} mm joins root and start of contact on the {1}'s {2} flank</source>
   <translation>没有 {0} mm 的圆角能连接{1}{2}齿面的齿根与啮合起点</translation>
  </message>
  <message>
   <source>no known format; use {0}</source>
   <translation>未知格式；请用 {0}</translation>
  </message>
  <message>
   <source>no permission</source>
   <translation>没有权限</translation>
  </message>
  <message>
   <source>no radius does with this spiral angle; use a spiral angle of at most {0}°</source>
   <translation>此螺旋角下无合适半径；请取螺旋角至多 {0}°</translation>
  </message>
  <message>
   <source>no radius does: use a narrower face width or a smaller spiral angle</source>
   <translation>无合适半径：请用较窄齿宽或较小螺旋角</translation>
  </message>
  <message>
   <source>no such preset; the nearest is {0}{1}; presets: {2}</source>
   <translation>没有此预设；最接近的是 {0}{1}；预设：{2}</translation>
  </message>
  <message>
   <source>none of the {0} faces is a flank of this {1}; {2}</source>
   <translation>{0} 个面中没有{1}的齿面；{2}</translation>
  </message>
  <message>
   <source>nothing in it belongs to a design of GearStudio; {0}</source>
   <translation>其中没有任何内容属于 GearStudio 的设计；{0}</translation>
  </message>
  <message>
   <source>numbers in a design file have a point, not a comma; write “{0} = {1}.{2}”</source>
   <translation>设计文件中的数字用小数点，不用逗号；请写 “{0} = {1}.{2}”</translation>
  </message>
  <message>
   <source>of a pair only the part 'gear' is written, not {0}</source>
   <translation>齿轮副只写出 'gear' 部分，不含 {0}</translation>
  </message>
  <message>
   <source>one line of up to {0} characters</source>
   <translation>一行，至多 {0} 个字符</translation>
  </message>
  <message>
   <source>pictures are written as .png or .jpg</source>
   <translation>图片以 .png 或 .jpg 写出</translation>
  </message>
  <message>
   <source>pipe along the tooth trace</source>
   <translation>沿齿线的管状扫掠</translation>
  </message>
  <message>
   <source>placing the tooth spaces</source>
   <translation>正在放置齿槽</translation>
  </message>
  <message>
   <source>points along each side</source>
   <translation>每边点数</translation>
  </message>
  <message>
   <source>points of the wheel's flank never touch the pinion</source>
   <translation>大轮齿面的点从不接触小轮</translation>
  </message>
  <message>
   <source>points {0} mm apart are too many; use {1} mm or more</source>
   <translation>点距 {0} mm 使点数过多；请取 {1} mm 或更大</translation>
  </message>
  <message>
   <source>polar angle lies inside the base cone: the involute does not exist there</source>
   <translation>极角位于基锥内：那里不存在渐开线</translation>
  </message>
  <message>
   <source>psi, trace</source>
   <translation>psi，齿线</translation>
  </message>
  <message>
   <source>reading</source>
   <translation>正在读取</translation>
  </message>
  <message>
   <source>recovery format {0} is not the {1} that this program reads</source>
   <translation>恢复格式 {0} 不是本程序读取的 {1}</translation>
  </message>
  <message>
   <source>setting the pages</source>
   <translation>正在排版</translation>
  </message>
  <message>
   <source>smaller amounts on both flanks of this member</source>
   <translation>此轮两侧齿面取较小的量</translation>
  </message>
  <message>
   <source>smaller modifications, or other depths</source>
   <translation>较小的修形或其他齿高</translation>
  </message>
  <message>
   <source>some are flanks of a gear of the other hand</source>
   <translation>有些是反旋向齿轮的齿面</translation>
  </message>
  <message>
   <source>some are flanks of the {0}</source>
   <translation>有些是{0}的齿面</translation>
  </message>
  <message>
   <source>some are in {0}: give the file the right unit</source>
   <translation>有些以 {0} 为单位：请为文件设定正确单位</translation>
  </message>
  <message>
   <source>studying {0}, {1}</source>
   <translation>正在研究 {0}，{1}</translation>
  </message>
  <message>
   <source>tables or lists in it are nested too deeply for a design</source>
   <translation>其中的表或列表嵌套过深，不是设计</translation>
  </message>
  <message>
   <source>take less misalignment</source>
   <translation>请减小安装误差</translation>
  </message>
  <message>
   <source>taking points</source>
   <translation>正在取点</translation>
  </message>
  <message>
   <source>taking points of {0}</source>
   <translation>正在从 {0} 取点</translation>
  </message>
  <message>
   <source>the CAD kernel cannot read this as STEP</source>
   <translation>CAD 内核无法将其读作 STEP</translation>
  </message>
  <message>
   <source>the CAD kernel cannot read this as {0}; it may be cut off or damaged</source>
   <translation>CAD 内核无法将其读作 {0}；可能不完整或已损坏</translation>
  </message>
  <message>
   <source>the CAD kernel could not write the {0} file and gave no reason; try another format or folder</source>
   <translation>CAD 内核无法写入 {0} 文件，且未说明原因；请尝试其他格式或文件夹</translation>
  </message>
  <message>
   <source>the CAD kernel made no face of the surface ({0})</source>
   <translation>CAD 内核未能由曲面生成面（{0}）</translation>
  </message>
  <message>
   <source>the arc of {0} mm does not cross {1} from {2} to {3} mm at less than {4}°; {5}</source>
   <translation>{0} mm 的圆弧不能以小于 {4}° 横跨{1}（{2} 至 {3} mm）；{5}</translation>
  </message>
  <message>
   <source>the conjugate flank has no point where one was asked for; it is undercut or too short there</source>
   <translation>共轭齿面在所求处没有点；该处根切或过短</translation>
  </message>
  <message>
   <source>the disk is full</source>
   <translation>磁盘已满</translation>
  </message>
  <message>
   <source>the disk is read-only</source>
   <translation>磁盘只读</translation>
  </message>
  <message>
   <source>the disk quota is used up</source>
   <translation>磁盘配额已用完</translation>
  </message>
  <message>
   <source>the disk reports a fault</source>
   <translation>磁盘报告故障</translation>
  </message>
  <message>
   <source>the edge of a chamfer at the end of the teeth could not be followed</source>
   <translation>无法跟踪端部倒角的边</translation>
  </message>
  <message>
   <source>the file is empty and holds no design; {0}, or an earlier copy of it</source>
   <translation>文件为空，不含任何设计；{0}，或其较早的副本</translation>
  </message>
  <message>
   <source>the file is gone; its record is still there</source>
   <translation>文件已不存在；其记录仍在</translation>
  </message>
  <message>
   <source>the file is not as it was written: its checksum is another</source>
   <translation>文件与写出时不同：校验和不符</translation>
  </message>
  <message>
   <source>the file is too large for this disk</source>
   <translation>文件对此磁盘过大</translation>
  </message>
  <message>
   <source>the fillet of a hypoid tooth could not be found</source>
   <translation>找不到准双曲面齿的圆角</translation>
  </message>
  <message>
   <source>the fillets of neighbouring {0} teeth overlap, however small they are</source>
   <translation>{0}相邻轮齿的圆角无论多小都会重叠</translation>
  </message>
  <message>
   <source>the film could not be encoded; try a smaller picture, or the other kind of file</source>
   <translation>影片无法编码；请尝试较小的画面或另一种文件类型</translation>
  </message>
  <message>
   <source>the flank is undercut below the start of contact</source>
   <translation>齿面在接触起点以下根切</translation>
  </message>
  <message>
   <source>the flank's curvature is infinite on the base cone; take points above it</source>
   <translation>齿面曲率在基锥上无穷大；请取其上方的点</translation>
  </message>
  <message>
   <source>the flanks of neighbouring {0} teeth meet above the root cone</source>
   <translation>{0}相邻齿的齿面在根锥以上相交</translation>
  </message>
  <message>
   <source>the flanks' normal pressure angles would be {0}° and {1}°, outside 0° to 45°; use a factor of at most {2}</source>
   <translation>齿面法向压力角将为 {0}° 和 {1}°，超出 0° 至 45°；请取系数至多 {2}</translation>
  </message>
  <message>
   <source>the gear's axis lies along {0}, turn it to +z</source>
   <translation>齿轮轴沿 {0}，请转到 +z</translation>
  </message>
  <message>
   <source>the header names no column {0}; it needs x, y and z</source>
   <translation>标题行没有列 {0}；需要 x、y 和 z</translation>
  </message>
  <message>
   <source>the header says {0}; convert the points to mm</source>
   <translation>标题行单位为 {0}；请将点换算为 mm</translation>
  </message>
  <message>
   <source>the heading of a table stands alone on its line and between brackets, as “[pair]”</source>
   <translation>表标题单独占一行，并写在方括号内，如 “[pair]”</translation>
  </message>
  <message>
   <source>the heel</source>
   <translation>大端</translation>
  </message>
  <message>
   <source>the job could not be sent: {0}: {1}</source>
   <translation>任务无法发送：{0}：{1}</translation>
  </message>
  <message>
   <source>the kernel could not cut the tooth spaces from the blank</source>
   <translation>内核无法从轮坯切出齿槽</translation>
  </message>
  <message>
   <source>the kernel's interpolation of the points failed</source>
   <translation>内核的点插值失败</translation>
  </message>
  <message>
   <source>the kernel's {0} failed: {1}</source>
   <translation>内核的{0}失败：{1}</translation>
  </message>
  <message>
   <source>the kernel's {0} gave {1} faces where one was expected</source>
   <translation>内核的{0}给出 {1} 个面，预期一个</translation>
  </message>
  <message>
   <source>the name is too long</source>
   <translation>名称过长</translation>
  </message>
  <message>
   <source>the number of the format is missing; write format = {0} in the first line</source>
   <translation>缺少格式号；请在第一行写 format = {0}</translation>
  </message>
  <message>
   <source>the order of convergence takes three constructions or more</source>
   <translation>收敛阶需要三个以上构造</translation>
  </message>
  <message>
   <source>the part {0} is not offered; parts: {1}</source>
   <translation>不提供部分 {0}；可用：{1}</translation>
  </message>
  <message>
   <source>the points are {0} mm rms from this {1}'s flanks as they lie; they fit when the best fit may turn and shift the part</source>
   <translation>这些点按原位距{1}齿面 {0} mm rms；允许最佳拟合转动和移动时即可符合</translation>
  </message>
  <message>
   <source>the points do not lie on this {0}'s flanks: {1} mm rms are left after the best fit{2}; {3}</source>
   <translation>这些点不在{0}齿面上：最佳拟合后剩余 {1} mm rms{2}；{3}</translation>
  </message>
  <message>
   <source>the points do not tell turning and shifting apart; measure more of the flanks or fix one of the two</source>
   <translation>这些点不能区分转动与移动；请多测齿面或固定其一</translation>
  </message>
  <message>
   <source>the points fit this {0} badly: {1} µm rms are left after the best fit, and no single number of the design explains them. Check that the part is of this design, and all points of its flanks</source>
   <translation>这些点与此{0}吻合不好：最佳拟合后均方根偏差仍有 {1} µm，且没有任何单个设计参数能解释。请检查零件是否属于此设计，以及所有点是否都在其齿面上</translation>
  </message>
  <message>
   <source>the points fit this {0} badly: {1} µm rms are left after the best fit; {2}. Check that the part is of this design, or give the design the value that it was made with</source>
   <translation>这些点与此{0}吻合不好：最佳拟合后均方根偏差仍有 {1} µm；{2}。请检查零件是否属于此设计，或将设计改为其加工时的数值</translation>
  </message>
  <message>
   <source>the points look as if they were in {0}: multiplied by {1} they lie on the {2}'s teeth; convert them to mm</source>
   <translation>这些点似乎以 {0} 为单位：乘 {1} 后位于{2}的齿上；请换算为 mm</translation>
  </message>
  <message>
   <source>the recursion of ISO 23509 Method 1 finds no pitch cones for this pair</source>
   <translation>ISO 23509 方法 1 的递推找不到此副的节锥</translation>
  </message>
  <message>
   <source>the root of the pinion</source>
   <translation>小轮齿根</translation>
  </message>
  <message>
   <source>the root of the wheel</source>
   <translation>大轮齿根</translation>
  </message>
  <message>
   <source>the solid is not closed</source>
   <translation>实体未封闭</translation>
  </message>
  <message>
   <source>the solid is not valid</source>
   <translation>实体无效</translation>
  </message>
  <message>
   <source>the standard taper</source>
   <translation>标准收缩</translation>
  </message>
  <message>
   <source>the start of contact does not reach over the pinion's whole face; the pair is undercut there</source>
   <translation>接触起点未覆盖小轮全齿宽；该处根切</translation>
  </message>
  <message>
   <source>the surface has no tangent plane somewhere; it is folded or starts on the base cone</source>
   <translation>曲面某处无切平面；有折叠或始于基锥</translation>
  </message>
  <message>
   <source>the teeth up to their heel corners</source>
   <translation>齿直至其大端角</translation>
  </message>
  <message>
   <source>the text is not UTF-8 but UTF-16; save the file as UTF-8 in your editor</source>
   <translation>文本不是 UTF-8，而是 UTF-16；请在编辑器中将文件另存为 UTF-8</translation>
  </message>
  <message>
   <source>the tilted root line</source>
   <translation>倾斜齿根线</translation>
  </message>
  <message>
   <source>the tip of the pinion</source>
   <translation>小轮齿顶</translation>
  </message>
  <message>
   <source>the tip of the wheel</source>
   <translation>大轮齿顶</translation>
  </message>
  <message>
   <source>the toe</source>
   <translation>小端</translation>
  </message>
  <message>
   <source>the value after the sign = is missing; put it there, or take the line out to have the usual “{0}”</source>
   <translation>等号后缺少数值；请补上，或删除该行以使用 “{0}” 的默认值</translation>
  </message>
  <message>
   <source>the value is empty; {0}</source>
   <translation>值为空；{0}</translation>
  </message>
  <message>
   <source>the value is neither a number, as “3.5”, nor a text between straight quotation marks</source>
   <translation>该值既不是数字（如 “3.5”），也不是直引号中的文本</translation>
  </message>
  <message>
   <source>the volume differs by {0}</source>
   <translation>体积相差 {0}</translation>
  </message>
  <message>
   <source>the web's front face, {0} mm from the apex, must lie on the front cone between {1} and {2} mm; change the thickness by {3} mm</source>
   <translation>辐板前面距锥顶 {0} mm，必须在前锥 {1} 与 {2} mm 之间；请将厚度改变 {3} mm</translation>
  </message>
  <message>
   <source>the wheel's cone of {0}° leaves the pinion no cone to match; use smaller addendum and dedendum angles, the uniform taper or a smaller shaft angle</source>
   <translation>大轮锥角 {0}° 使小轮无匹配锥；请用较小的齿顶角和齿根角、等高齿或较小轴交角</translation>
  </message>
  <message>
   <source>the whole face width</source>
   <translation>全齿宽</translation>
  </message>
  <message>
   <source>the {0} could not be fitted within {1} µm (got {2} µm)</source>
   <translation>{0}无法拟合到 {1} µm 以内（得 {2} µm）</translation>
  </message>
  <message>
   <source>the {0} misses its limits by {1} mm and cannot be continued that far; the variant is too inaccurate for this design to make a tooth of</source>
   <translation>{0}偏离其界限 {1} mm，无法延伸那么远；该方案对此设计过于不精确，无法成齿</translation>
  </message>
  <message>
   <source>the {0} of a pair with {1}</source>
   <translation>{1}齿轮副的{0}</translation>
  </message>
  <message>
   <source>the {0}'s flanks are up to {1} µm from those of the design, which a rotating line cannot sweep; the faces are held against the flanks that it does sweep</source>
   <translation>{0}齿面与设计的相差至多 {1} µm，滚动直线无法扫出设计齿面；各面与其所能扫出的齿面比较</translation>
  </message>
  <message>
   <source>the {0}'s teeth are pointed below their face cone</source>
   <translation>{0}的齿在面锥以下变尖</translation>
  </message>
  <message>
   <source>the {0}'s {1} {2}</source>
   <translation>{0}的{1}{2}</translation>
  </message>
  <message>
   <source>there are no faces in it; points can be taken from solids and surfaces only</source>
   <translation>其中没有面；只能从实体和曲面取点</translation>
  </message>
  <message>
   <source>there are no points in it</source>
   <translation>其中没有点</translation>
  </message>
  <message>
   <source>there is a file where the folder should be</source>
   <translation>应为文件夹处有一个文件</translation>
  </message>
  <message>
   <source>there is a folder of this name</source>
   <translation>有同名文件夹</translation>
  </message>
  <message>
   <source>there is no such file</source>
   <translation>没有此文件</translation>
  </message>
  <message>
   <source>there is no such file or folder</source>
   <translation>没有此文件或文件夹</translation>
  </message>
  <message>
   <source>these values make no gear: {0}</source>
   <translation>这些值不能构成齿轮：{0}</translation>
  </message>
  <message>
   <source>they are of another gear (number of teeth, spiral angle, hand)</source>
   <translation>它们属于另一齿轮（齿数、螺旋角、旋向）</translation>
  </message>
  <message>
   <source>they are of another gear, or the origin is not at the apex and z not along the axis</source>
   <translation>它们属于另一齿轮，或原点不在锥顶、z 不沿轴</translation>
  </message>
  <message>
   <source>they fit a gear of the other hand</source>
   <translation>它们符合反旋向的齿轮</translation>
  </message>
  <message>
   <source>they fit the {0}</source>
   <translation>它们符合{0}</translation>
  </message>
  <message>
   <source>they fit {0}: {1} mm rms are left</source>
   <translation>它们符合{0}：剩余 {1} mm rms</translation>
  </message>
  <message>
   <source>this is a device, not a file</source>
   <translation>这是设备，不是文件</translation>
  </message>
  <message>
   <source>this is a folder, not a file</source>
   <translation>这是文件夹，不是文件</translation>
  </message>
  <message>
   <source>this is no complete {0} file; it may be cut off or damaged</source>
   <translation>这不是完整的 {0} 文件；可能不完整或已损坏</translation>
  </message>
  <message>
   <source>this is no heading of a table, as “[pair]”, no entry, as “pinion_teeth = 17”, and no comment after #</source>
   <translation>这既不是表标题（如 “[pair]”），也不是条目（如 “pinion_teeth = 17”），也不是 # 后的注释</translation>
  </message>
  <message>
   <source>this is no record of an export, or a damaged one; export again</source>
   <translation>这不是导出记录，或已损坏；请重新导出</translation>
  </message>
  <message>
   <source>this is no recovery file of GearStudio ({0})</source>
   <translation>这不是 GearStudio 的恢复文件（{0}）</translation>
  </message>
  <message>
   <source>this is no text, so no design of GearStudio; {0}</source>
   <translation>这不是文本，因此不是 GearStudio 的设计；{0}</translation>
  </message>
  <message>
   <source>this is not a file name</source>
   <translation>这不是文件名</translation>
  </message>
  <message>
   <source>this is not the {0} {1} of this design: what is in it fills {2} mm</source>
   <translation>这不是本设计的 {0} {1}：其内容尺寸为 {2} mm</translation>
  </message>
  <message>
   <source>this is {0}, no design of GearStudio; {1}</source>
   <translation>这是{0}，不是 GearStudio 的设计；{1}</translation>
  </message>
  <message>
   <source>this misalignment takes {0} mm of backlash that the pair does not have: the teeth jam; give more backlash</source>
   <translation>此安装误差需要 {0} mm 侧隙，而齿轮副没有：齿会卡死；请增加侧隙</translation>
  </message>
  <message>
   <source>toe chamfer</source>
   <translation>小端倒角</translation>
  </message>
  <message>
   <source>toe end</source>
   <translation>小端端面</translation>
  </message>
  <message>
   <source>tooth contact</source>
   <translation>轮齿接触</translation>
  </message>
  <message>
   <source>tooth {0} {1}</source>
   <translation>第 {0} 齿 {1}</translation>
  </message>
  <message>
   <source>triangles lie {0} µm from the surfaces {1}</source>
   <translation>三角形距曲面 {0} µm，{1}</translation>
  </message>
  <message>
   <source>triangles within {0} mm and {1}° of the {2} would be more than {3} million; allow a larger distance or angle</source>
   <translation>{2}按 {0} mm 和 {1}° 的三角形将超过 {3} 百万；请放宽距离或角度</translation>
  </message>
  <message>
   <source>turning the blank</source>
   <translation>正在车削轮坯</translation>
  </message>
  <message>
   <source>unexpected error: {0}</source>
   <translation>意外错误：{0}</translation>
  </message>
  <message>
   <source>unknown key; the nearest known one is {0}</source>
   <translation>未知键；最接近的是 {0}</translation>
  </message>
  <message>
   <source>unknown spacing {0}; use one of {1}</source>
   <translation>未知间距 {0}；请用 {1} 之一</translation>
  </message>
  <message>
   <source>use a larger clearance or shallower teeth</source>
   <translation>请使用较大的顶隙或较矮的轮齿</translation>
  </message>
  <message>
   <source>use a smaller clearance, or other depths that leave the teeth more space at the root</source>
   <translation>请使用较小的顶隙，或使齿根留有更多空间的其他齿高</translation>
  </message>
  <message>
   <source>use a smaller fillet factor or a larger clearance</source>
   <translation>请减小齿根圆角系数或增大顶隙</translation>
  </message>
  <message>
   <source>use a smaller offset</source>
   <translation>请用较小偏置</translation>
  </message>
  <message>
   <source>use a smaller offset or face width</source>
   <translation>请用较小偏置或齿宽</translation>
  </message>
  <message>
   <source>use a spiral angle of at least {0}°</source>
   <translation>请取螺旋角至少 {0}°</translation>
  </message>
  <message>
   <source>use at least {0} mm</source>
   <translation>请取至少 {0} mm</translation>
  </message>
  <message>
   <source>use at most {0} mm</source>
   <translation>请取至多 {0} mm</translation>
  </message>
  <message>
   <source>use {0}</source>
   <translation>请用 {0}</translation>
  </message>
  <message>
   <source>waiting for pictures</source>
   <translation>正在等待图片</translation>
  </message>
  <message>
   <source>weighing</source>
   <translation>正在称重</translation>
  </message>
  <message>
   <source>whole number</source>
   <translation>整数</translation>
  </message>
  <message>
   <source>with an offset each member has a transverse pressure angle of its own; give the normal one</source>
   <translation>有偏置时两轮端面压力角各不相同；请给出法向压力角</translation>
  </message>
  <message>
   <source>with an offset the spiral angle is given at the mean point; use mean</source>
   <translation>有偏置时螺旋角在中点给出；请用中点</translation>
  </message>
  <message>
   <source>with {0} instead of {1} it would be {2} µm</source>
   <translation>若为{0}而不是{1}，则为 {2} µm</translation>
  </message>
  <message>
   <source>writing {0}</source>
   <translation>正在写出 {0}</translation>
  </message>
  <message>
   <source>{0} MB is too large for a design file; the most is 1 MB</source>
   <translation>{0} MB 对设计文件过大；最多 1 MB</translation>
  </message>
  <message>
   <source>{0} after reading the file back</source>
   <translation>回读文件后{0}</translation>
  </message>
  <message>
   <source>{0} asks for fillets of {1} mm on the {2}, which do not fit between its flanks and its root; they get {3} mm, as with a fillet factor of {4}</source>
   <translation>{0} 要求{2}的圆角为 {1} mm，在齿面与齿根之间放不下；实际为 {3} mm，相当于齿根圆角系数 {4}</translation>
  </message>
  <message>
   <source>{0} cannot be a {1}; {2}</source>
   <translation>{0} 不能作为{1}；{2}</translation>
  </message>
  <message>
   <source>{0} cannot be written as {1}; formats: {2}</source>
   <translation>{0} 不能写成 {1}；格式：{2}</translation>
  </message>
  <message>
   <source>{0} is a text; {1}, with a point and without quotation marks</source>
   <translation>{0} 是文本；{1}，用小数点且不加引号</translation>
  </message>
  <message>
   <source>{0} is above the most of {1}{2}; {3}</source>
   <translation>{0} 大于最大值 {1}{2}；{3}</translation>
  </message>
  <message>
   <source>{0} is below the least of {1}{2}; {3}</source>
   <translation>{0} 小于最小值 {1}{2}；{3}</translation>
  </message>
  <message>
   <source>{0} is more than the wheel's {1} teeth; the pinion is the member with fewer: exchange them</source>
   <translation>{0} 多于大轮的 {1} 齿；小轮应为齿数少者：请交换</translation>
  </message>
  <message>
   <source>{0} is newer than format {1}, which this GearStudio reads; update GearStudio to open the file, in which nothing was changed</source>
   <translation>{0} 比本 GearStudio 可读的格式 {1} 新；请更新 GearStudio 后再打开该文件，文件未作任何更改</translation>
  </message>
  <message>
   <source>{0} is not a design; a design is a table of keys</source>
   <translation>{0} 不是设计；设计是键的表</translation>
  </message>
  <message>
   <source>{0} is not a finite number; {1}</source>
   <translation>{0} 不是有限数；{1}</translation>
  </message>
  <message>
   <source>{0} is not a format number; write format = {1}</source>
   <translation>{0} 不是格式号；请写 format = {1}</translation>
  </message>
  <message>
   <source>{0} is not a table; write [{1}] and its keys below it</source>
   <translation>{0} 不是表；请写 [{1}] 及其下的键</translation>
  </message>
  <message>
   <source>{0} is not a whole number; {1}</source>
   <translation>{0} 不是整数；{1}</translation>
  </message>
  <message>
   <source>{0} is not a {1}; {2}</source>
   <translation>{0} 不是{1}；{2}</translation>
  </message>
  <message>
   <source>{0} is not above {1}{2}; {3}</source>
   <translation>{0} 不大于 {1}{2}；{3}</translation>
  </message>
  <message>
   <source>{0} is not one of the choices; {1}</source>
   <translation>{0} 不在可选项中；{1}</translation>
  </message>
  <message>
   <source>{0} is too narrow to make a tooth; use at least {1}</source>
   <translation>{0} 太窄无法成齿；请取至少 {1}</translation>
  </message>
  <message>
   <source>{0} is unknown; this GearStudio reads format {1}</source>
   <translation>{0} 未知；本 GearStudio 读取格式 {1}</translation>
  </message>
  <message>
   <source>{0} leaves a member no addendum at the mean point; use a smaller profile shift or a larger addendum factor</source>
   <translation>{0} 使某轮中点无齿顶高；请用较小变位或较大齿顶高系数</translation>
  </message>
  <message>
   <source>{0} leaves the {1} no root: {2}; use {3}</source>
   <translation>{0} 使{1}没有齿根：{2}；请用 {3}</translation>
  </message>
  <message>
   <source>{0} leaves the {1} no root: {2}; {3}</source>
   <translation>{0} 使{1}没有齿根：{2}；{3}</translation>
  </message>
  <message>
   <source>{0} leaves the {1} no {2} ({3} mm): its teeth do not reach across the pitch cone; use {4}</source>
   <translation>{0} 使{1}没有{2}（{3} mm）：齿未跨越节锥；请用 {4}</translation>
  </message>
  <message>
   <source>{0} leaves the {1}'s teeth no thickness at the pitch cone; use {2}</source>
   <translation>{0} 使{1}的齿在节锥处无厚度；请用 {2}</translation>
  </message>
  <message>
   <source>{0} lets the {1}'s fillet reach into the flank that meets the mate's tip; use {2}</source>
   <translation>{0} 使{1}的圆角伸入与配对轮齿顶啮合的齿面；请用 {2}</translation>
  </message>
  <message>
   <source>{0} lets the {1}'s tip reach below the {2}'s base cone, where no conjugate flank is: the teeth interfere there; use {3}</source>
   <translation>{0} 使{1}齿顶低于{2}基锥，该处无共轭齿面：齿会干涉；请用 {3}</translation>
  </message>
  <message>
   <source>{0} makes no conjugate pinion: its {1}; use {2}</source>
   <translation>{0} 得不到共轭小轮：其{1}；请用 {2}</translation>
  </message>
  <message>
   <source>{0} makes the contact ratio only {1}: a pair of teeth parts before the next one meets; a larger addendum factor, spiral angle or face width raises it</source>
   <translation>{0} 使重合度仅 {1}：一对齿在下一对啮合前脱离；增大齿顶高系数、螺旋角或齿宽可提高</translation>
  </message>
  <message>
   <source>{0} makes the {1}'s fillet reach its tip: no flank is left; use {2}</source>
   <translation>{0} 使{1}的圆角到达齿顶：没有齿面；请用 {2}</translation>
  </message>
  <message>
   <source>{0} makes the {1}'s fillets overlap: its root is rounded fully, with a radius of {2} mm instead of {3} mm; use {4} to keep a root land</source>
   <translation>{0} 使{1}的圆角重叠：齿根全圆，半径 {2} mm 而非 {3} mm；请用 {4} 以保留齿根面</translation>
  </message>
  <message>
   <source>{0} makes the {1}'s flanks meet below its tip cone: the teeth are pointed; use {2}</source>
   <translation>{0} 使{1}齿面在面锥以下相交：齿变尖；请用 {2}</translation>
  </message>
  <message>
   <source>{0} makes the {1}'s teeth touch each other at the foot: there is no tooth space; use {2}</source>
   <translation>{0} 使{1}的齿在根部相触：没有齿槽；请用 {2}</translation>
  </message>
  <message>
   <source>{0} makes the {1}'s tip only {2} mm wide at the heel, less than {3} modules; a smaller addendum factor or profile shift makes it wider</source>
   <translation>{0} 使{1}大端齿顶仅宽 {2} mm，小于 {3} 个模数；减小齿顶高系数或变位可加宽</translation>
  </message>
  <message>
   <source>{0} measured points are too few; a best fit takes 3 or more</source>
   <translation>{0} 个测点太少；最佳拟合至少需 3 个</translation>
  </message>
  <message>
   <source>{0} mm is more than half the outer cone distance of {1} mm; use at most {2} mm</source>
   <translation>{0} mm 超过外锥距 {1} mm 的一半；请取至多 {2} mm</translation>
  </message>
  <message>
   <source>{0} mm is too narrow to make a tooth at an outer cone distance of {1} mm; use at least {2} mm</source>
   <translation>外锥距 {1} mm 时 {0} mm 太窄无法成齿；请取至少 {2} mm</translation>
  </message>
  <message>
   <source>{0} of the points lie beside the {1}'s teeth: they are {2} to {3} mm from the apex and at {4}° to {5}° from the axis, its flanks at {6} to {7} mm and {8}° to {9}°; {10}</source>
   <translation>{0} 的点在{1}齿之外：距锥顶 {2} 至 {3} mm，距轴 {4}° 至 {5}°，而齿面为 {6} 至 {7} mm 和 {8}° 至 {9}°；{10}</translation>
  </message>
  <message>
   <source>{0} puts the {1}'s root cone at {2}°, and it must be above 0°; use {3}</source>
   <translation>{0} 使{1}根锥角为 {2}°，必须大于 0°；请用 {3}</translation>
  </message>
  <message>
   <source>{0} puts the {1}'s tip at {2}° to {3}° along the face and leaves no involute flank above its {4} cone of {5}°; use {6}</source>
   <translation>{0} 使{1}齿顶沿齿宽位于 {2}° 至 {3}°，在其 {5}° 的{4}锥以上没有渐开线齿面；请用 {6}</translation>
  </message>
  <message>
   <source>{0} solids instead of {1} were found</source>
   <translation>找到 {0} 个实体而非 {1} 个</translation>
  </message>
  <message>
   <source>{0} teeth</source>
   <translation>{0} 齿</translation>
  </message>
  <message>
   <source>{0} to {1}</source>
   <translation>{0} 至 {1}</translation>
  </message>
  <message>
   <source>{0} tooth of the {1}</source>
   <translation>{1}的{0}齿</translation>
  </message>
  <message>
   <source>{0} tooth space</source>
   <translation>{0}齿槽</translation>
  </message>
  <message>
   <source>{0} tooth's lower side</source>
   <translation>{0}齿的下侧</translation>
  </message>
  <message>
   <source>{0} {1} flank, cut off at its limits,</source>
   <translation>在界限处截断的{0}{1}齿面</translation>
  </message>
  <message>
   <source>{0} {1} of at {2} {3}{4}</source>
   <translation>{1}{2} {3}{4}</translation>
  </message>
  <message>
   <source>{0} {1}solid{2}, {3} faces, {4} mm³ (relative difference {5})</source>
   <translation>{0} 个{1}实体，{3} 个面，{4} mm³（相对差 {5}）</translation>
  </message>
  <message>
   <source>{0} µm on the {1}'s {2} flank {3}; use {4}</source>
   <translation>{1}{2}齿面 {0} µm {3}；请用 {4}</translation>
  </message>
  <message>
   <source>{0} µm remained with {1} nodes where a step of the construction needs {2} µm; raise methods.tolerance_um</source>
   <translation>{1} 个节点时剩余 {0} µm，而构造的一步需要 {2} µm；请增大 methods.tolerance_um</translation>
  </message>
  <message>
   <source>{0}: the flanks touch on {1}: edge contact; less misalignment or more crowning avoids it</source>
   <translation>{0}：齿面在{1}接触：棱边接触；减小安装误差或加大鼓形可避免</translation>
  </message>
  <message>
   <source>{0}: {1} failed: {2}</source>
   <translation>{0}：{1}失败：{2}</translation>
  </message>
  <message>
   <source>{0}° at the toe makes the mean spiral angle more than {1}°; use {2}</source>
   <translation>小端 {0}° 使中点螺旋角大于 {1}°；请用 {2}</translation>
  </message>
  <message>
   <source>{0}° gives the {1} a pitch cone of {2}°, and it must stay below 90°; use at most {3}°, or numbers of teeth nearer to each other</source>
   <translation>{0}° 使{1}节锥角为 {2}°，必须小于 90°；请取至多 {3}°，或使齿数更接近</translation>
  </message>
  <message>
   <source>{0}° makes the {1}'s face cone, {2}°, open backwards (above 90°) as that of an internal gear; a smaller shaft angle avoids it</source>
   <translation>{0}° 使{1}面锥角 {2}° 向后张开（超过 90°），如同内齿轮；减小轴交角可避免</translation>
  </message>
  <message>
   <source>“{0}” stands in line {1} too; keep one of them</source>
   <translation>“{0}” 在第 {1} 行也有；请只保留一处</translation>
  </message>
 </context>
</TS>
